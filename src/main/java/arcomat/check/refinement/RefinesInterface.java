package arcomat.check.refinement;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.TypeVariable;
import arcomat.symbols.signatures.Signature;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** ARC0402: every port of a refined component exists here with the same direction and type. */
public final class RefinesInterface implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (Signature.Refinement refinement : component.signature().refines()) {
            refinement
                    .resolution()
                    .found()
                    .ifPresent(refined -> check(component, refined, refinement, findings));
        }
    }

    private static void check(
            ComponentSymbol component,
            Signature refined,
            Signature.Refinement refinement,
            Findings findings) {
        List<PortSymbol> missing = new ArrayList<>();
        for (PortSymbol promised : refined.ports()) {
            Optional<PortSymbol> port = component.port(promised.name());
            if (port.isEmpty()) {
                missing.add(promised);
            } else if (!fits(port.get(), promised)) {
                reportOther(port.get(), promised, component, refinement, findings);
            }
        }
        if (!missing.isEmpty()) {
            reportMissing(missing, component, refinement, findings);
        }
    }

    private static boolean fits(PortSymbol port, PortSymbol promised) {
        return port.direction() == promised.direction() && areSame(port.type(), promised.type());
    }

    private static boolean areSame(TypeSymbol type, TypeSymbol promised) {
        return type.isErroneous()
                || promised.isErroneous()
                || promised instanceof TypeVariable
                || type.equals(promised);
    }

    private static void reportOther(
            PortSymbol port,
            PortSymbol promised,
            ComponentSymbol component,
            Signature.Refinement refinement,
            Findings findings) {
        boolean declaredHere = component.signature().ownPorts().contains(port);
        findings.report(
                        declaredHere ? port.nameSpan() : refinement.node().span(),
                        "port '%s' is '%s', but in the refined '%s' it is '%s'; declare it as"
                                + " there",
                        port.name(),
                        Wording.declaration(port),
                        refinement.node(),
                        Wording.declaration(promised))
                .related(promised.nameSpan(), "the port of the refined component");
    }

    private static void reportMissing(
            List<PortSymbol> missing,
            ComponentSymbol component,
            Signature.Refinement refinement,
            Findings findings) {
        List<String> ports = missing.stream().map(Wording::declaration).toList();
        findings.report(
                refinement.node(),
                "'%s' has %s that '%s' lacks; declare %s",
                refinement.node(),
                missing.size() == 1 ? "a port" : "ports",
                component.name(),
                Wording.quoted(ports));
        for (PortSymbol port : missing) {
            findings.related(port.nameSpan(), "not declared in '" + component.name() + "'");
        }
    }
}
