package arcomat.check.stereotypes;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;

import java.util.List;

/** ARC0501: a stereotype is one of those that mean something. */
public final class StereotypeKnown implements Check.OnStereotypes {

    @Override
    public Law law() {
        return Law.warning("ARC0501");
    }

    @Override
    public void check(
            List<Stereotype> stereotypes,
            Carrier carrier,
            Node owner,
            Context context,
            Findings findings) {
        for (Stereotype stereotype : stereotypes) {
            String name = stereotype.name().text();
            if (KnownStereotype.find(name).isEmpty()) {
                report(stereotype, name, findings);
            }
        }
    }

    private static void report(Stereotype stereotype, String name, Findings findings) {
        findings.reportUnknown(
                stereotype.name().span(),
                "stereotype '" + name + "' means nothing here",
                name,
                KnownStereotype.names(),
                "delete it, or suppress this finding if another tool needs it");
    }
}
