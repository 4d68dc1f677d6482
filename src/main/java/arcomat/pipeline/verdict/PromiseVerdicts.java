package arcomat.pipeline.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Answered.Question;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.verdict.TextVerdict.Sheet;
import arcomat.pipeline.verdict.TextVerdict.Tone;
import arcomat.report.page.PageText;
import arcomat.report.verdict.VerdictLine;
import arcomat.report.verdict.VerdictPage;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.signatures.Signature;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Whether promises are kept, each at the clause, the automaton or the invariant that makes it. A
 * promise of several instances is kept if each of them keeps it.
 */
record PromiseVerdicts(LoweredModels models, List<Answered> answers) {
    List<TextVerdict> at(List<VerdictPlace> places) {
        List<TextVerdict> verdicts = new ArrayList<>();
        for (VerdictPlace place : places) {
            answers.stream()
                    .filter(each -> isAbout(each, place))
                    .reduce(PromiseVerdicts::worse)
                    .map(worst -> verdict(place, worst))
                    .ifPresent(verdicts::add);
        }
        return verdicts;
    }

    private boolean isAbout(Answered answered, VerdictPlace place) {
        return switch (place.kind()) {
            case REFINEMENT -> isAboutClause(answered, place);
            case REQUIREMENT -> isAboutAutomaton(answered, place.subject());
            case INVARIANT ->
                    answered.question() == Question.INVARIANT
                            && place.subject().isAround(answered.place());
            case INHERITED -> isInherited(answered, place.subject());
            case AUTOMATON, PROGRAM, TEST -> false;
        };
    }

    /** Where nothing was compared, one of the two takes arguments. */
    private boolean isAboutClause(Answered answered, VerdictPlace clause) {
        Optional<Span> refined = refined(clause);
        if (answered.question() != Question.REFINEMENT || refined.isEmpty()) {
            return false;
        }
        List<Span> sides =
                answered.sides().stream().map(Promise::component).map(each -> each.span()).toList();
        return sides.isEmpty()
                ? answered.place().equals(clause.subject())
                        || answered.place().equals(refined.get())
                : sides.equals(List.of(clause.subject(), refined.get()));
    }

    /** The whole text of the component that a clause names. */
    private Optional<Span> refined(VerdictPlace clause) {
        return models.checked().workspace().components().stream()
                .map(ComponentSymbol::signature)
                .flatMap(each -> each.refines().stream())
                .filter(each -> each.node().span().equals(clause.span()))
                .flatMap(each -> each.resolution().found().stream())
                .map(Signature::node)
                .map(each -> each.span())
                .findFirst();
    }

    private static boolean isAboutAutomaton(Answered answered, Span automaton) {
        return answered.question() == Question.REFINEMENT && answered.place().equals(automaton);
    }

    /** Whether what is asked of a component stands elsewhere. */
    private static boolean isInherited(Answered answered, Span component) {
        return answered.question() == Question.REFINEMENT
                && !answered.sides().isEmpty()
                && answered.sides().get(0).component().span().equals(component)
                && !component.isAround(answered.place());
    }

    private static Answered worse(Answered first, Answered second) {
        Answer both = first.verdict().answer().and(second.verdict().answer());
        return first.verdict().answer() == both ? first : second;
    }

    private static TextVerdict verdict(VerdictPlace place, Answered answered) {
        return new TextVerdict(
                place,
                tone(answered.verdict().answer()),
                line(place, answered),
                new Sheet("index.html", () -> PageText.render(VerdictPage.of("verify", answered))));
    }

    /** Beside the name of another component it has to be said what holds or fails. */
    private static String line(VerdictPlace place, Answered answered) {
        String line = VerdictLine.of(answered);
        return place.kind() == VerdictPlace.Kind.INHERITED ? "what it asks: " + line : line;
    }

    private static Tone tone(Answer answer) {
        return switch (answer) {
            case HOLDS -> Tone.GOOD;
            case FAILS -> Tone.BAD;
            case UNKNOWN -> Tone.OPEN;
        };
    }
}
