package arcomat.check.stereotypes;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.check.law.Suppressions;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;

import java.util.Optional;
import java.util.function.Predicate;

/**
 * ARC0506: who suppresses a finding names its code and a reason.
 *
 * @param known whether somebody who is there finds something with a code
 */
record SuppressWellFormed(Predicate<String> known) implements Check.OnStereotype {
    /** Findings of analyses have codes that this room does not know one by one. */
    private static final String ANALYSIS = "ARC10\\d\\d";

    @Override
    public void check(Stereotype stereotype, Carrier carrier, Context context, Findings findings) {
        if (stereotype.name().text().equals(Suppressions.STEREOTYPE)) {
            check(stereotype, findings);
        }
    }

    private void check(Stereotype stereotype, Findings findings) {
        Optional<Suppressions.Value> value =
                stereotype.value().map(Name::text).flatMap(Suppressions.Value::parse);
        if (value.isEmpty()) {
            findings.report(
                    stereotype,
                    "'suppress' needs a code and a reason, as in <<suppress = \"ARC0108:"
                            + " reason\">>");
            return;
        }
        String code = value.get().code();
        if (!known.test(code) && !isOfAnalysis(code)) {
            findings.report(
                    stereotype.value().get(),
                    "no check has the code '%s'; 'suppress' takes the code of a finding",
                    code);
        }
    }

    /** Whether others than checks find that, too. */
    static boolean isOfAnalysis(String code) {
        return code.matches(ANALYSIS);
    }
}
