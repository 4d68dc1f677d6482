package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** {@code {..}}: what a transition reads or writes. */
public record Block(Span span, List<Item> items) implements Node {
    public sealed interface Item extends Node {}

    /** {@code name = value}; the name may be left out. */
    public record Message(Span span, Optional<Name> name, Value value) implements Item {}

    /** {@code call expression}: parsed to be reported as unsupported. */
    public record Call(Span span, Expression expression) implements Item {}

    /** {@code name++} or {@code name--}: parsed to be reported as unsupported. */
    public record Increment(Span span, QualifiedName name, boolean up) implements Item {}

    /** The right-hand side of an item. */
    public sealed interface Value extends Node {
        /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
        <R> R match(Cases<R> cases);

        /**
         * One answer for each form.
         *
         * @param <R> what is answered
         */
        interface Cases<R> {
            R alternatives(Alternatives alternatives);

            R sequence(Sequence sequence);

            R single(Single single);

            R noMessage(NoMessage noMessage);

            R anyMessage(AnyMessage anyMessage);
        }
    }

    /** {@code alt {a, b}}: one of them. */
    public record Alternatives(Span span, List<Value> values) implements Value {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.alternatives(this);
        }
    }

    /** {@code [a, b]}: one after the other. */
    public record Sequence(Span span, List<Expression> messages) implements Value {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.sequence(this);
        }
    }

    public record Single(Span span, Expression expression) implements Value {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.single(this);
        }
    }

    /** {@code --}. */
    public record NoMessage(Span span) implements Value {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.noMessage(this);
        }
    }

    /** {@code ?}: some message, whichever. */
    public record AnyMessage(Span span) implements Value {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.anyMessage(this);
        }
    }
}
