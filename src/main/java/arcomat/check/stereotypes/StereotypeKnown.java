package arcomat.check.stereotypes;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.tree.Stereotype;

/** ARC0501: a stereotype is one of those that mean something. */
public final class StereotypeKnown implements Check.OnStereotype {

    @Override
    public void check(Stereotype stereotype, Carrier carrier, Context context, Findings findings) {
        String name = stereotype.name().text();
        if (KnownStereotype.find(name).isEmpty()) {
            findings.reportUnknown(
                    stereotype.name().span(),
                    "stereotype '" + name + "' means nothing here",
                    name,
                    KnownStereotype.names(),
                    "delete it, or suppress this finding if another tool needs it");
        }
    }
}
