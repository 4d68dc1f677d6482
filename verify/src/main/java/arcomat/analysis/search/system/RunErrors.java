package arcomat.analysis.search.system;

import arcomat.analysis.search.reduction.SureResults;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.semantics.network.Network;

/**
 * Whether a run of an automaton may end with an error: by its completion, outside a range, or at a
 * division by zero. Errs on the side of yes.
 */
public final class RunErrors {
    private RunErrors() {}

    /** Of a composition: where events queue up, there may be no room for one more. */
    public static boolean arePossible(Network network) {
        return network.component().profile() == Component.Profile.EVENT_DRIVEN
                || network.instances().stream()
                        .flatMap(instance -> instance.component().automata().stream())
                        .anyMatch(RunErrors::arePossible);
    }

    public static boolean arePossible(Automaton automaton) {
        return automaton.completion() == Automaton.Completion.ERROR
                || automaton.transitions().stream().anyMatch(RunErrors::arePossible);
    }

    private static boolean arePossible(Automaton.Transition transition) {
        return !SureResults.isSureCondition(transition)
                || !transition.assignments().stream()
                        .allMatch(a -> SureResults.isSure(a.value(), a.variable().type()))
                || !transition.sends().stream().allMatch(RunErrors::isSure);
    }

    private static boolean isSure(Automaton.Send send) {
        return send.emission().values().stream()
                .allMatch(value -> SureResults.isSure(value, send.port().type()));
    }
}
