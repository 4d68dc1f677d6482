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

    record State(Span span, List<Stereotype> stereotypes, Name name) implements Node {}

    record Initial(Span span, List<Name> states, Optional<Block> output)
            implements AutomatonElement {}

    /**
     * Without a target the transition is a loop.
     *
     * @param rank it is taken only where none with a smaller one is enabled; texts have no word for
     *     it, and guests may have
     */
    record Transition(
            Span span,
            Name source,
            Optional<Name> target,
            Optional<Guard> guard,
            Optional<Block> input,
            Optional<Block> output,
            int rank)
            implements AutomatonElement {
        /** The same with another rank. */
        public Transition withRank(int other) {
            return new Transition(span, source, target, guard, input, output, other);
        }
    }

    /**
     * {@code [kind: condition]}.
     *
     * @param kind {@code ocl} or {@code java} where written
     */
    record Guard(Span span, Optional<Name> kind, Expression condition) implements Node {}
}
