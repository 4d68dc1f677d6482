package arcomat.pipeline.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Answered.Question;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.model.Component;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.verdict.TextVerdict.Sheet;
import arcomat.pipeline.verdict.TextVerdict.Tone;
import arcomat.report.page.PageText;
import arcomat.report.verdict.VerdictLine;
import arcomat.report.verdict.VerdictPage;
import arcomat.semantics.Promise;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.signatures.Signature;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

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
        return answered.question() == Question.REFINEMENT
                && meant(clause).anyMatch(each -> each.isAbout(answered));
    }

    /** What a clause means for each configuration of the component that it stands at. */
    private Stream<Meant> meant(VerdictPlace clause) {
        return models.checked().workspace().meantComponents().stream()
                .map(ComponentSymbol::signature)
                .flatMap(
                        heir ->
                                heir.refines().stream()
                                        .filter(each -> each.node().span().equals(clause.span()))
                                        .flatMap(each -> each.resolution().found().stream())
                                        .map(refined -> new Meant(heir, refined)));
    }

    /** A component and what it is to refine, each with its features chosen. */
    private record Meant(Signature heir, Signature refined) {

        boolean isAbout(Answered answered) {
            List<Component> sides = answered.sides().stream().map(Promise::component).toList();
            return sides.size() < 2
                    ? answered.place().equals(heir.node().span())
                            || answered.place().equals(refined.node().span())
                    : isOne(sides.get(0), heir) && isOne(sides.get(1), refined);
        }

        /** All configurations have one text. */
        private static boolean isOne(Component compared, Signature component) {
            boolean isChosen = !component.declaration().configuration().choices().isEmpty();
            return compared.span().equals(component.node().span())
                    && (!isChosen || compared.qualifiedName().equals(component.qualifiedName()));
        }
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
