package arcomat.check.structure.reference;

import arcomat.check.facts.VisibleNames;
import arcomat.check.law.Check;
import arcomat.check.naming.JavaClassUnique;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.QualifiedName;

import java.util.List;

/**
 * ARC0111: a component that is used or extended exists, and it is clear which one is meant. (Hab16
 * R3, R4)
 */
public final class ComponentExists implements Check.OnComponentUse {

    @Override
    public void check(ComponentUse use, Context context, Findings findings) {
        String name = use.reference().name();
        Resolution<Signature> resolution = use.reference().resolution();
        if (resolution.isUnknown()) {
            reportUnknown(name, use.name(), context, findings);
        } else if (resolution.isAmbiguous() && !areDuplicates(resolution.candidates())) {
            findings.report(
                    use.name(),
                    "'%s' could mean several components; write the full name of one",
                    name);
            for (Signature candidate : resolution.candidates()) {
                findings.related(candidate.nameSpan(), candidate.qualifiedName());
            }
        }
    }

    /** Definitions of one full name are the business of {@link JavaClassUnique}. */
    private static boolean areDuplicates(List<Signature> candidates) {
        return candidates.stream().map(Signature::qualifiedName).distinct().count() == 1;
    }

    private static void reportUnknown(
            String name, QualifiedName written, Context context, Findings findings) {
        if (context.scope().type(written).isFound()) {
            findings.report(written, "'%s' is a type of messages; a part needs a component", name);
            return;
        }
        List<String> elsewhere = VisibleNames.componentsElsewhere(written, context);
        if (elsewhere.size() == 1) {
            Imports.reportMissing(written, "component", elsewhere.get(0), context.unit(), findings);
            return;
        }
        findings.reportUnknown(
                written.span(),
                "there is no component '" + name + "'",
                name,
                VisibleNames.components(context.component().orElseThrow(), context),
                "declare or import it");
    }
}
