package arcomat.check.stereotypes;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.check.law.Suppressions;
import arcomat.tree.Name;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/** ARC0506: who suppresses a finding names its code and a reason. */
public final class SuppressWellFormed implements Check.OnStereotypes {
    /** Findings of analyses have codes that this room does not know one by one. */
    private static final String ANALYSIS = "ARC10\\d\\d";

    private final Supplier<List<Check>> checks;

    /**
     * @param checks all of them, this one included
     */
    public SuppressWellFormed(Supplier<List<Check>> checks) {
        this.checks = checks;
    }

    @Override
    public Law law() {
        return Law.error("ARC0506");
    }

    @Override
    public void check(
            List<Stereotype> stereotypes,
            Carrier carrier,
            Node owner,
            Context context,
            Findings findings) {
        for (Stereotype stereotype : stereotypes) {
            if (stereotype.name().text().equals(Suppressions.STEREOTYPE)) {
                check(stereotype, findings);
            }
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
        List<String> codes = codes();
        if (!codes.contains(code) && !isOfAnalysis(code)) {
            findings.report(
                    stereotype.value().get(),
                    "no check has the code '" + code + "'; 'suppress' takes the code of a finding");
        }
    }

    /** Whether others than checks find that, too. */
    static boolean isOfAnalysis(String code) {
        return code.matches(ANALYSIS);
    }

    private List<String> codes() {
        List<String> codes = new ArrayList<>();
        for (Check check : checks.get()) {
            codes.add(check.law().code());
        }
        return codes;
    }
}
