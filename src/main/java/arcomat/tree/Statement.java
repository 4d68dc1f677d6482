package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** What stands in {@code do {..}}: it is done one after the other. */
public sealed interface Statement extends Node {
    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R sequence(Sequence sequence);

        R assignment(Assignment assignment);

        R choice(Choice choice);

        R locals(Locals locals);
    }

    /** {@code {..}}: names that are declared in it are known to its end. */
    record Sequence(Span span, List<Statement> statements) implements Statement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.sequence(this);
        }
    }

    /**
     * {@code name = value;}, also what {@code name += 2;} and {@code name++;} are short for.
     *
     * @param message always with a name
     */
    record Assignment(Span span, Block.Message message) implements Statement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.assignment(this);
        }
    }

    /** {@code if (condition) then else otherwise}. */
    record Choice(Span span, Expression condition, Statement then, Optional<Statement> otherwise)
            implements Statement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.choice(this);
        }
    }

    /** {@code Integer a = 1, b;}: names for values until the end of the braces around. */
    record Locals(Span span, TypeReference type, List<Variable> variables) implements Statement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.locals(this);
        }
    }
}
