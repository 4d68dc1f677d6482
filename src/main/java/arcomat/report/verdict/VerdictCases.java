package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.report.finding.JunitXml.Case;
import arcomat.report.finding.JunitXml.Case.Outcome;
import arcomat.report.text.Style;

import java.util.List;
import java.util.Optional;

/** Promises as cases, one each. */
public final class VerdictCases {
    private static final String GROUP = "verify";

    private VerdictCases() {}

    public static List<Case> of(List<Answered> answers) {
        return answers.stream().map(VerdictCases::of).toList();
    }

    private static Case of(Answered each) {
        Verdict verdict = each.verdict();
        return switch (verdict.answer()) {
            case HOLDS -> of(each, Outcome.PASSED, "", notes(verdict));
            case FAILS -> of(each, Outcome.FAILED, headline(each), details(each));
            case UNKNOWN -> of(each, Outcome.UNDECIDED, headline(each), details(each));
        };
    }

    private static Case of(Answered each, Outcome outcome, String message, String details) {
        return new Case(GROUP, name(each), Optional.of(each.place()), outcome, message, details);
    }

    /** What was promised; of a promise without a right side, who made it. */
    static String name(Answered each) {
        return Terms.name(each);
    }

    private static String headline(Answered each) {
        return Terms.headline(each);
    }

    private static String details(Answered each) {
        return VerdictText.render(each, Style.PLAIN);
    }

    private static String notes(Verdict verdict) {
        return verdict.notes().isEmpty() ? "" : String.join("\n", verdict.notes()) + "\n";
    }
}
