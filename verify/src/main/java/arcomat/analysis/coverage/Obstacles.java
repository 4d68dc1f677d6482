package arcomat.analysis.coverage;

import arcomat.analysis.coverage.TransitionTests.Uncovered;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Trace;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.Fault;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** What keeps transitions from being taken, as a search meets it. */
final class Obstacles {
    private final ComponentSemantics behaviour;
    private final Map<Goal, String> wrong = new HashMap<>();
    private final Set<Goal> enabled = new HashSet<>();
    private final Set<Place> states = new HashSet<>();

    private record Place(int automaton, int state) {}

    Obstacles(ComponentSemantics behaviour) {
        this.behaviour = behaviour;
    }

    /** Notes states that can be reached. */
    void visited(List<Configuration> configurations) {
        for (int i = 0; i < configurations.size(); i++) {
            states.add(new Place(i, configurations.get(i).state()));
        }
    }

    /**
     * Notes what each automaton wanted to do: the others may forbid it, and it may go wrong, also
     * where the others let the component go on.
     *
     * @param errs whether an error is possible
     */
    void wanted(List<Configuration> before, Input input, boolean errs) {
        boolean several = before.size() > 1;
        for (int i = 0; (several || errs) && i < before.size(); i++) {
            StepRelation relation = behaviour.relations().get(i);
            StepRelation.Choices choices = relation.choices(before.get(i), input);
            for (Trace.Taken taken : choices.enabled()) {
                tryOut(relation, taken, before.get(i), input);
            }
            for (Fault fault : choices.faults()) {
                fault.taken().ifPresent(taken -> goesWrong(relation, taken, fault));
            }
        }
    }

    private void tryOut(
            StepRelation relation, Trace.Taken taken, Configuration before, Input input) {
        Goal goal = new Goal(relation.automaton(), taken.index());
        try {
            relation.take(taken, before, input);
            enabled.add(goal);
        } catch (Fault fault) {
            goesWrong(relation, taken, fault);
        }
    }

    private void goesWrong(StepRelation relation, Trace.Taken taken, Fault fault) {
        wrong.putIfAbsent(new Goal(relation.automaton(), taken.index()), fault.getMessage());
    }

    /**
     * Why a transition was not met.
     *
     * @param stopped why the search does not know everything, if it does not
     */
    Uncovered of(Goal goal, Optional<String> stopped) {
        boolean certain = stopped.isEmpty();
        if (!Subject.connected(goal.automaton()).get(goal.transition().source())) {
            return new Uncovered(goal, unreachable(goal), true);
        }
        boolean forbidden = enabled.contains(goal);
        if (wrong.containsKey(goal)) {
            String others = forbidden ? "the other automata forbid what it sends, or " : "";
            return new Uncovered(goal, others + "it goes wrong: " + wrong.get(goal), certain);
        }
        if (forbidden) {
            String reason = "whenever it is enabled, the other automata forbid what it sends";
            return new Uncovered(goal, reason, certain);
        }
        if (!certain) {
            return new Uncovered(goal, "not met so far: " + stopped.get(), false);
        }
        boolean met = states.contains(new Place(automaton(goal), goal.transition().source()));
        String never = "it is never enabled in '" + goal.source() + "'";
        return new Uncovered(goal, met ? never : unreachable(goal), true);
    }

    private int automaton(Goal goal) {
        int position = 0;
        while (behaviour.relations().get(position).automaton() != goal.automaton()) {
            position++;
        }
        return position;
    }

    private static String unreachable(Goal goal) {
        return "'" + goal.source() + "' cannot be reached";
    }
}
