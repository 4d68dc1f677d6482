package arcomat.guest;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Value;

import java.util.List;

/**
 * All that the runs of an automaton may come to: where it may be, and what happens there on one
 * letter of each kind that its guards tell apart.
 *
 * @param arguments one per parameter of the component
 * @param configurations by their numbers; those of shorter runs come first
 * @param reactions in the order in which they were looked at
 * @param whole whether nothing else can be reached; what never happens is sure only then
 */
public record AutomatonRuns(
        Component component,
        Automaton automaton,
        List<Value> arguments,
        List<Reached> configurations,
        List<Reaction> reactions,
        boolean whole) {
    public AutomatonRuns {
        arguments = List.copyOf(arguments);
        configurations = List.copyOf(configurations);
        reactions = List.copyOf(reactions);
    }

    /**
     * Where an automaton may be.
     *
     * @param number of the configuration, from 0 on
     * @param state by its position in {@link Automaton#states}
     * @param variables values in the order of declaration
     * @param initial whether a shortest run to it is one that has read nothing
     */
    public record Reached(int number, int state, List<Value> variables, boolean initial) {
        public Reached {
            variables = List.copyOf(variables);
        }
    }

    /**
     * What happens on a letter.
     *
     * @param from number of the configuration
     * @param ways one for each transition that is enabled; without any, the automaton's completion
     *     says what happens
     * @param guardFails whether a guard ends the run in an error
     */
    public record Reaction(int from, Letter input, List<Way> ways, boolean guardFails) {
        public Reaction {
            ways = List.copyOf(ways);
        }
    }

    /**
     * A transition that may be taken.
     *
     * @param transition its position in {@link Automaton#transitions}; that says what is sent
     * @param to number of the configuration; -1 where the run ends in an error
     */
    public record Way(int transition, int to) {}
}
