package arcomat.analysis.automaton;

import arcomat.analysis.automaton.Situation.Alternative;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.Fault;
import arcomat.semantics.Input;
import arcomat.semantics.Reaction;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToIntFunction;

/** Looks at what a letter does in a configuration. */
record Stepper(Subject subject) {

    /**
     * @param next the number of the visit that a reaction leads to
     */
    Situation situation(Visit visit, Value[] letter, ToIntFunction<Reaction> next) {
        Input input = Input.of(letter);
        List<Alternative> alternatives = new ArrayList<>();
        try {
            for (Trace.Taken taken : subject.relation().enabled(visit.configuration(), input)) {
                alternatives.add(alternative(taken, visit, input, next));
            }
        } catch (Fault inGuard) {
            return new Situation(visit, letter, List.of(), Optional.of(inGuard));
        }
        return new Situation(visit, letter, alternatives, Optional.empty());
    }

    private Alternative alternative(
            Trace.Taken taken, Visit visit, Input input, ToIntFunction<Reaction> next) {
        try {
            Reaction reaction = subject.relation().take(taken, visit.configuration(), input);
            return new Alternative(
                    taken, Optional.of(reaction), Optional.empty(), next.applyAsInt(reaction));
        } catch (Fault fault) {
            return new Alternative(taken, Optional.empty(), Optional.of(fault), -1);
        }
    }

    /** The latched ports that have had a message after a letter. */
    Set<Integer> latched(Visit before, Value[] letter) {
        if (subject.component().profile() == Component.Profile.TIME_SYNCHRONOUS) {
            return Set.of();
        }
        List<Port> inputs = subject.component().inputs();
        Set<Integer> latched = new HashSet<>(before.latched());
        for (int port = 0; port < letter.length; port++) {
            if (inputs.get(port).latched() && letter[port] != null) {
                latched.add(port);
            }
        }
        return latched;
    }
}
