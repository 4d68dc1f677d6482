package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** What stands in the body of an automaton. */
public sealed interface AutomatonElement extends Node {

    /** {@code variable Integer a = 1, b;}; input and output occur in bare automata only. */
    record Declaration(Span span, Kind kind, TypeReference type, List<Variable> variables)
            implements AutomatonElement {}

    enum Kind {
        VARIABLE,
        INPUT,
        OUTPUT
    }

    record States(Span span, List<State> states) implements AutomatonElement {}

    /**
     * @param within what it stands in, from the outermost on; texts have no word for it, and guests
     *     may have
     */
    record State(Span span, List<Stereotype> stereotypes, Name name, List<Name> within)
            implements Node {
        /** The same in other states. */
        public State within(List<Name> others) {
            return new State(span, stereotypes, name, others);
        }
    }

    /**
     * {@code initial a, b / {..};}. It may stand before the states that it declares.
     *
     * @param declared the states, where they are declared with it
     * @param output what happens at once; empty also where there are actions
     * @param actions what happens one after the other
     */
    record Initial(
            Span span,
            List<Name> states,
            List<State> declared,
            Optional<Block> output,
            Optional<Statement.Sequence> actions)
            implements AutomatonElement {
        /** Without statements, of states that are declared elsewhere. */
        public Initial(Span span, List<Name> states, Optional<Block> output) {
            this(span, states, List.of(), output, Optional.empty());
        }
    }

    /**
     * Without a target the transition is a loop.
     *
     * @param output what happens at once; empty also where there are actions
     * @param actions what happens one after the other
     * @param rank it is taken only where none with a smaller one is enabled; texts have no word for
     *     it, and guests may have
     * @param turn it is taken only where nothing is there that one with a smaller number waits for
     */
    record Transition(
            Span span,
            Name source,
            Optional<Name> target,
            Optional<Guard> guard,
            Optional<Block> input,
            Optional<Block> output,
            Optional<Statement.Sequence> actions,
            int rank,
            int turn)
            implements AutomatonElement {
        /** The same in another order. */
        public Transition ordered(int otherRank, int otherTurn) {
            return new Transition(
                    span, source, target, guard, input, output, actions, otherRank, otherTurn);
        }
    }

    /**
     * {@code [kind: condition]}.
     *
     * @param kind {@code ocl} or {@code java} where written
     */
    record Guard(Span span, Optional<Name> kind, Expression condition) implements Node {}
}
