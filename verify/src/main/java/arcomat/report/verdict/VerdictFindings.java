package arcomat.report.verdict;

import arcomat.analysis.contradiction.NoRun;
import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Moment;
import arcomat.report.finding.Reported;
import arcomat.report.finding.Reported.Standing;
import arcomat.report.finding.Reported.Step;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Promises that are broken as errors, and those that nobody could decide on as warnings. */
public final class VerdictFindings {
    /** A component does not keep what it says it keeps. */
    public static final String BROKEN = "ARC0404";

    /** It is not known whether a component keeps it. */
    public static final String UNDECIDED = "ARC0405";

    /** It is kept, but only since there may be no run. */
    public static final String NO_RUN = "ARC0406";

    private VerdictFindings() {}

    public static List<Reported> of(List<Answered> answers) {
        return answers.stream()
                .filter(each -> each.verdict().answer() != Answer.HOLDS || hasNoRun(each))
                .map(VerdictFindings::of)
                .toList();
    }

    private static boolean hasNoRun(Answered each) {
        return NoRun.isReasonOf(each.verdict());
    }

    private static Reported of(Answered each) {
        Verdict verdict = each.verdict();
        Span place = each.place().firstLine();
        String headline = Terms.headline(each);
        if (hasNoRun(each)) {
            String note = verdict.notes().get(verdict.notes().size() - 1);
            return Reported.of(
                    Diagnostic.warning(NO_RUN, place, headline + "; " + note), Standing.NEW);
        }
        if (verdict.answer() == Answer.UNKNOWN) {
            return Reported.of(
                    Diagnostic.warning(UNDECIDED, place, "unknown: " + headline), Standing.NEW);
        }
        Stream<String> placeless =
                verdict.explanation().stream()
                        .filter(sentence -> sentence.place().isEmpty())
                        .map(Sentence::text);
        String message =
                Stream.concat(placeless, verdict.notes().stream())
                        .map(text -> "\n" + text)
                        .collect(Collectors.joining("", headline, ""));
        Diagnostic finding = Diagnostic.error(BROKEN, place, message);
        for (Sentence sentence : verdict.explanation()) {
            if (sentence.place().isPresent()) {
                finding = finding.withRelated(sentence.place().get(), sentence.text());
            }
        }
        return new Reported(finding, Standing.NEW, "", steps(each, place));
    }

    /** The run that is forbidden. It has no places of its own: it happens in the component. */
    private static List<Step> steps(Answered each, Span place) {
        List<Step> steps = new ArrayList<>();
        for (Moment moment : each.verdict().trace()) {
            String step = Terms.of(each).step() + " " + steps.size();
            steps.add(new Step(step + ": " + text(each, moment), place));
        }
        return steps;
    }

    private static String text(Answered each, Moment moment) {
        String inputs = String.join(", ", VerdictText.inputs(moment.input()));
        String outputs = String.join(", ", VerdictText.shown(moment));
        return "in %s, out %s; %s is in %s%s"
                .formatted(
                        inputs.isEmpty() ? "--" : inputs,
                        outputs.isEmpty() ? "--" : outputs,
                        each.left(),
                        moment.left(),
                        each.question() == Answered.Question.INVARIANT ? "" : right(each, moment));
    }

    private static String right(Answered each, Moment moment) {
        String states = String.join(" or ", moment.right());
        return "; "
                + each.right()
                + (states.isEmpty() ? " does not allow that" : " is in " + states);
    }
}
