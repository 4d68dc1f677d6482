package arcomat.analysis.game.controller;

import arcomat.analysis.game.Outcomes;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.StepRelation.Start;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/** A machine and requirements side by side, with every input: without the engine. */
public final class Walk {
    private record Pair(Configuration machine, int position) {}

    private Walk() {}

    /**
     * The first input found after which a deterministic machine does what the requirements forbid.
     */
    static Optional<String> broken(Outcomes outcomes, Component machine) {
        return broken(outcomes, machine, Set.of());
    }

    /**
     * The first input found after which it errs, or can be made to, though it need not have been.
     */
    public static Optional<String> erring(Outcomes outcomes, Component machine) {
        return outcomes.lost(false).flatMap(erring -> broken(outcomes, machine, erring));
    }

    /**
     * @param avoided positions that it has to keep away from while it can; if any, so is the end
     */
    private static Optional<String> broken(
            Outcomes outcomes, Component machine, Set<Integer> avoided) {
        StepRelation relation =
                ComponentSemantics.of(machine, java.util.List.of()).relations().get(0);
        Start start = relation.starts().get(0);
        Deque<Pair> open = new ArrayDeque<>();
        Set<Pair> met = new HashSet<>();
        int opening = outcomes.opening(start.output());
        if (opening == Outcomes.BROKEN) {
            return Optional.of("at the beginning");
        }
        open.add(new Pair(start.configuration(), opening));
        while (!open.isEmpty()) {
            Pair before = open.removeFirst();
            if (before.position == Outcomes.END || !met.add(before)) {
                continue;
            }
            for (Value[] letter : outcomes.inputs()) {
                if (!outcomes.isPossible(before.position, letter)) {
                    continue;
                }
                Input input = Input.of(letter);
                StepRelation.Prospect prospect = relation.prospect(before.machine, input);
                Reaction reaction =
                        prospect.reactions().isEmpty() ? null : prospect.reactions().get(0);
                int after =
                        outcomes.after(
                                before.position,
                                letter,
                                reaction == null ? null : reaction.output());
                boolean stays = avoided.contains(after) || after == Outcomes.END;
                if (after == Outcomes.BROKEN
                        || !avoided.isEmpty() && !avoided.contains(before.position) && stays) {
                    return Optional.of(before + " " + input);
                }
                if (reaction != null) {
                    open.add(new Pair(reaction.next(), after));
                }
            }
        }
        return Optional.empty();
    }
}
