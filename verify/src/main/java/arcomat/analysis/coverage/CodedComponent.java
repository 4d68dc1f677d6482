package arcomat.analysis.coverage;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Port;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;

/**
 * A component, and what code makes of it.
 *
 * @param promise what the component promises
 * @param asRun as code runs it: where a completion leaves things open, nothing is sent
 * @param promising errs where it would promise nothing any more, or errs: all other runs promise
 *     something
 * @param silent whether code sends nothing where no transition is enabled: no message has to be
 *     made up
 */
record CodedComponent(Promise promise, Promise asRun, Promise promising, boolean silent) {

    static CodedComponent of(Promise promise) {
        boolean silent = promise.component().outputs().stream().noneMatch(Port::total);
        Promise asRun =
                silent
                        ? promise.withAutomata(
                                promise.automata().stream().map(CodedComponent::asRun).toList())
                        : promise;
        return new CodedComponent(promise, asRun, promising(promise, asRun), silent);
    }

    private static Automaton asRun(Automaton automaton) {
        return automaton.completion() == Completion.ERROR
                ? automaton
                : automaton.with(Completion.IGNORE);
    }

    private static Promise promising(Promise promise, Promise asRun) {
        List<Automaton> automata = new ArrayList<>();
        for (int i = 0; i < promise.automata().size(); i++) {
            boolean chaos = promise.automata().get(i).completion() == Completion.CHAOS;
            Automaton own = asRun.automata().get(i);
            automata.add(chaos ? own.with(Completion.ERROR) : own);
        }
        return promise.withAutomata(automata);
    }

    /** Whether a completion leaves open what code does not. */
    boolean decides() {
        return !asRun.equals(promise);
    }

    /**
     * Whether all runs that promise something to their end are among those of {@link #promising}:
     * where one automaton is in chaos, others may go on, and what {@code output} leaves open, code
     * does not do.
     */
    boolean isPromisingAll() {
        return promise.automata().stream()
                .map(Automaton::completion)
                .allMatch(
                        each ->
                                each == Completion.IGNORE
                                        || each == Completion.ERROR
                                        || each == Completion.OUTPUT && !decides()
                                        || each == Completion.CHAOS
                                                && promise.automata().size() == 1);
    }
}
