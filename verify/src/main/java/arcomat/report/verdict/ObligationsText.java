package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;

import java.util.ArrayList;
import java.util.List;

/** Verdicts on many obligations: a line each, and a summary. */
public final class ObligationsText {
    private static final int WIDEST_ANSWER = 7;

    private ObligationsText() {}

    /** {@code holds p.New refines p.Old; 5 of 5 transitions of p.Old took part}. */
    public static String line(Answered answered, Style style) {
        Verdict verdict = answered.verdict();
        String blanks = " ".repeat(WIDEST_ANSWER - verdict.answer().name().length());
        List<String> remarks = new ArrayList<>(verdict.notes());
        if (verdict.answer() == Answer.UNKNOWN && verdict.explored().left().orElse(1) > 0) {
            remarks.add(VerdictText.explored(verdict));
        }
        String notes = remarks.isEmpty() ? "" : "; " + String.join("; ", remarks);
        String headline = Terms.headline(answered);
        return VerdictText.answer(verdict.answer(), style)
                + blanks
                + "  "
                + Printable.escape(headline)
                + style.quiet(Printable.escape(notes))
                + "\n";
    }

    /** A line for each, then the failures at length, then how many there are. */
    public static String all(List<Answered> answers, Style style) {
        StringBuilder out = new StringBuilder();
        answers.forEach(each -> out.append(line(each, style)));
        answers.stream()
                .filter(each -> each.verdict().answer() == Answer.FAILS)
                .forEach(each -> out.append('\n').append(VerdictText.render(each, style)));
        List<Verdict> verdicts = answers.stream().map(Answered::verdict).toList();
        return out + summary(verdicts, style) + "\n";
    }

    public static String summary(List<Verdict> verdicts, Style style) {
        if (verdicts.isEmpty()) {
            return "nothing to verify: no component refines another one or has an invariant, and no"
                    + " decomposition is required anything";
        }
        long fail = count(verdicts, Answer.FAILS);
        long unknown = count(verdicts, Answer.UNKNOWN);
        String text =
                "%d hold, %d fail, %d unknown"
                        .formatted(count(verdicts, Answer.HOLDS), fail, unknown);
        return fail > 0 ? style.error(text) : unknown > 0 ? style.warning(text) : style.good(text);
    }

    private static long count(List<Verdict> verdicts, Answer answer) {
        return verdicts.stream().filter(verdict -> verdict.answer() == answer).count();
    }
}
