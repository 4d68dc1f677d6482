package arcomat.check.structure.connector;

import arcomat.check.facts.MeantParts;
import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Nearest;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;

/** ARC0103: the ends of connectors name ports and instances that exist. (Hab16 CO3, R5 to R7) */
public final class ConnectorEndExists implements Check.OnConnector {

    @Override
    public void check(ConnectorSymbol connector, Context context, Findings findings) {
        ComponentSymbol component = context.component().orElseThrow();
        boolean unclear = connector.source().namesPart() || connector.target().namesPart();
        if (unclear && !component.lacksAncestor()) {
            PartsWithoutPorts.report(connector, findings);
        }
        check(component, connector.source(), findings);
        check(component, connector.target(), findings);
    }

    private static void check(ComponentSymbol component, End end, Findings findings) {
        switch (end.status()) {
            case NO_SUCH_PORT -> reportPort(component, end, findings);
            case NO_SUCH_INSTANCE -> reportInstance(component, end, findings);
            case NO_SUCH_PORT_OF_INSTANCE -> reportPortOfInstance(end, findings);
            case RESOLVED, COMPLETED, MALFORMED, EXCUSED, OTHER_SIZE -> {}
        }
    }

    private static void reportPort(ComponentSymbol component, End end, Findings findings) {
        if (component.lacksAncestor() || end.namesPart()) {
            return;
        }
        String message = "component '" + component.name() + "' has no port '" + end.text() + "'";
        List<String> owners = instancesWithPort(component, end.text());
        List<String> candidates = portNames(component.ports());
        if (owners.size() == 1 && Nearest.to(end.text(), candidates).isEmpty()) {
            String meant = owners.get(0) + "." + end.text();
            findings.report(end.span(), "%s; did you mean '%s'?", message, meant)
                    .fix(Fix.replace("Put the name of the part before it", end.span(), meant));
        } else {
            findings.reportUnknown(
                    end.span(),
                    message,
                    end.text(),
                    candidates,
                    "declare it, or connect another port");
        }
    }

    private static List<String> instancesWithPort(ComponentSymbol component, String port) {
        return component.instances().stream()
                .filter(instance -> instance.port(port).isPresent())
                .map(InstanceSymbol::name)
                .toList();
    }

    private static void reportInstance(ComponentSymbol component, End end, Findings findings) {
        String name = end.text().substring(0, end.text().indexOf('.'));
        if (MeantParts.isNamed(name, component)) {
            return; // told where it is declared
        }
        List<String> candidates = component.instances().stream().map(InstanceSymbol::name).toList();
        Span span =
                new Span(end.span().file(), end.span().start(), end.span().start() + name.length());
        findings.reportUnknown(
                span,
                "component '" + component.name() + "' has no part '" + name + "'",
                name,
                candidates,
                "declare it, or name another part");
    }

    private static void reportPortOfInstance(End end, Findings findings) {
        InstanceSymbol instance = end.instance().orElseThrow();
        String name = end.text().substring(end.text().lastIndexOf('.') + 1);
        Span span = new Span(end.span().file(), end.span().end() - name.length(), end.span().end());
        findings.reportUnknown(
                span,
                "'%s' of type '%s' has no port '%s'"
                        .formatted(instance.name(), instance.type().name(), name),
                name,
                portNames(instance.ports()),
                "connect another port");
    }

    private static List<String> portNames(List<PortSymbol> ports) {
        return ports.stream().map(PortSymbol::name).toList();
    }
}
