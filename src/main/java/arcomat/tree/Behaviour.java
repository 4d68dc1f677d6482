package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** A behaviour language embedded in a component: automata, or one that is translated into them. */
public sealed interface Behaviour extends Element
        permits Automaton, Behaviour.Computation, Behaviour.Implementation, Behaviour.Foreign {
    /** The automata that it consists of; none in other languages. */
    List<Automaton> automata();

    /** Whether its automata are what it means, and not what is written. */
    default boolean isMeaning() {
        return this instanceof Foreign || this instanceof Computation;
    }

    @Override
    default void accept(Element.Visitor visitor) {
        visitor.behaviour(this);
    }

    /**
     * {@code compute {..}}: done in each slice.
     *
     * @param automaton what it means; an {@code init} beside it is its start
     */
    record Computation(Span span, Automaton automaton) implements Behaviour {
        @Override
        public List<Automaton> automata() {
            return List.of(automaton);
        }
    }

    /**
     * {@code implementation Name {..}} of the older tools. A body of bare automaton elements is
     * read as one automaton without a name of its own.
     */
    record Implementation(Span span, Optional<Name> name, List<Automaton> automata)
            implements Behaviour {}

    /**
     * A behaviour in another language, the tool's own or that of a guest: {@code blink lamp {..}}.
     *
     * @param body between the braces, as it was written
     * @param gaps parts of the body that have errors in their syntax, which are told already; the
     *     rest is read
     * @param automata what it means; none until somebody who knows the language has said so
     */
    record Foreign(
            Span span,
            List<Stereotype> stereotypes,
            Name keyword,
            Optional<Name> name,
            Span body,
            List<Span> gaps,
            List<Automaton> automata)
            implements Behaviour {
        public Foreign {
            gaps = List.copyOf(gaps);
        }

        /** With what it means. */
        public Foreign meaning(Automaton automaton) {
            return new Foreign(span, stereotypes, keyword, name, body, gaps, List.of(automaton));
        }

        /** With parts that cannot be read. */
        public Foreign without(List<Span> gaps) {
            return new Foreign(span, stereotypes, keyword, name, body, gaps, automata);
        }

        /** No two begin at one place; the record's own would look at all that is written there. */
        @Override
        public int hashCode() {
            return span.hashCode();
        }
    }
}
