package arcomat.analysis.contradiction;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.semantics.Promise;

import java.util.List;
import java.util.stream.Collectors;

/**
 * Whether requirements agree only because some of them are in chaos: after an input that they do
 * not handle they ask for nothing any more. With completion {@code output} they would go on asking.
 */
final class Leniency {
    private Leniency() {}

    /** The same answer, with a note where a contradiction is hidden. */
    static Consistency noted(Promise promise, Consistency found, Budget budget) {
        boolean lenient =
                promise.automata().stream().anyMatch(a -> a.completion() == Completion.CHAOS);
        if (!lenient || promise.automata().size() < 2) {
            return found;
        }
        List<Automaton> strict = promise.automata().stream().map(Leniency::strict).toList();
        Promise other = new Promise(promise.component(), promise.arguments(), strict);
        Consistency hidden = Contradictions.check(other, false, budget);
        if (hidden.answer() != Answer.FAILS) {
            return found;
        }
        String names =
                hidden.contradictions().get(0).requirements().stream()
                        .map(Automaton::name)
                        .collect(Collectors.joining(", "));
        return found.with(
                "with completion output in place of chaos there is a contradiction ("
                        + names
                        + "); in chaos a requirement asks for nothing after an input that it does"
                        + " not handle");
    }

    private static Automaton strict(Automaton a) {
        return a.completion() == Completion.CHAOS ? a.with(Completion.OUTPUT) : a;
    }
}
