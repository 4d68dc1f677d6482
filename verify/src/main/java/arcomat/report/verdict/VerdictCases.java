package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
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
        if (verdict.answer() == Answer.HOLDS) {
            return of(each, Outcome.PASSED, "", notes(verdict));
        }
        return of(
                each,
                verdict.answer() == Answer.FAILS ? Outcome.FAILED : Outcome.UNDECIDED,
                Terms.headline(each),
                VerdictText.render(each, Style.PLAIN));
    }

    private static Case of(Answered each, Outcome outcome, String message, String details) {
        return new Case(
                GROUP, Terms.name(each), Optional.of(each.place()), outcome, message, details);
    }

    private static String notes(Verdict verdict) {
        return verdict.notes().isEmpty() ? "" : String.join("\n", verdict.notes()) + "\n";
    }
}
