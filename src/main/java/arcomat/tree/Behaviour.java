package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** A behaviour language embedded in a component: automata, or I/O tables. */
public sealed interface Behaviour extends Element
        permits Automaton, IoTable, Behaviour.Implementation {
    /** The automata that it consists of; none in other languages. */
    List<Automaton> automata();

    @Override
    default void accept(Element.Visitor visitor) {
        visitor.behaviour(this);
    }

    /**
     * {@code implementation Name {..}} of the older tools. A body of bare automaton elements is
     * read as one automaton without a name of its own.
     */
    record Implementation(Span span, Optional<Name> name, List<Automaton> automata)
            implements Behaviour {}
}
