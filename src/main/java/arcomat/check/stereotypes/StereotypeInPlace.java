package arcomat.check.stereotypes;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;

import java.util.List;

/** ARC0503: a stereotype stands on an element on which it has a meaning. */
public final class StereotypeInPlace implements Check.OnStereotypes {

    @Override
    public Law law() {
        return Law.error("ARC0503");
    }

    @Override
    public void check(
            List<Stereotype> stereotypes,
            Carrier carrier,
            Node owner,
            Context context,
            Findings findings) {
        for (Stereotype stereotype : stereotypes) {
            KnownStereotype.find(stereotype.name().text())
                    .filter(known -> !known.carriers().contains(carrier))
                    .ifPresent(known -> findings.report(stereotype, message(known, carrier)));
        }
    }

    private static String message(KnownStereotype known, Carrier carrier) {
        return "stereotype '"
                + known.name()
                + "' means nothing on "
                + carrier.words()
                + "; it belongs on "
                + places(known);
    }

    private static String places(KnownStereotype known) {
        StringBuilder places = new StringBuilder();
        for (Carrier carrier : Carrier.values()) {
            if (known.carriers().contains(carrier)) {
                places.append(places.isEmpty() ? "" : " or ").append(carrier.words());
            }
        }
        return places.toString();
    }
}
