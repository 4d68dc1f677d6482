package arcomat.check.stereotypes;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.tree.Stereotype;

import java.util.Arrays;
import java.util.stream.Collectors;

/** ARC0503: a stereotype stands on an element on which it has a meaning. */
public final class StereotypeInPlace implements Check.OnStereotype {

    @Override
    public void check(Stereotype stereotype, Carrier carrier, Context context, Findings findings) {
        KnownStereotype.find(stereotype.name().text())
                .filter(known -> !known.carriers().contains(carrier))
                .ifPresent(known -> findings.report(stereotype, message(known, carrier)));
    }

    private static String message(KnownStereotype known, Carrier carrier) {
        return "stereotype '%s' means nothing on %s; it belongs on %s"
                .formatted(known.name(), carrier.words(), places(known));
    }

    private static String places(KnownStereotype known) {
        return Arrays.stream(Carrier.values())
                .filter(known.carriers()::contains)
                .map(Carrier::words)
                .collect(Collectors.joining(" or "));
    }
}
