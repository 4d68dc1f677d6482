package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.model.Value;
import arcomat.semantics.expression.PartialEvaluation;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * Something about the messages of a letter that decides what the steps with it are: letters that
 * agree in all facts have the same steps, but for messages that they send on.
 */
sealed interface DataFact {
    /** A condition. */
    Expression when();

    /** All that it is about, the condition first. */
    List<Expression> expressions();

    /** Whether it depends on messages that are not known yet. */
    boolean isOpen();

    /**
     * The same about letters of which something is known.
     *
     * @param rest what is left of an expression then
     */
    DataFact with(UnaryOperator<Expression> rest);

    /** Whether the condition is true. */
    record Holds(Expression when) implements DataFact {
        @Override
        public List<Expression> expressions() {
            return List.of(when);
        }

        @Override
        public boolean isOpen() {
            return !isKnown(when);
        }

        @Override
        public DataFact with(UnaryOperator<Expression> rest) {
            return new Holds(rest.apply(when));
        }
    }

    /** Whether the condition is true, and two things that are sent then are the same message. */
    record Same(Expression when, Expression one, Expression two) implements DataFact {
        @Override
        public List<Expression> expressions() {
            return List.of(when, one, two);
        }

        @Override
        public boolean isOpen() {
            return !isFalse(when) && !one.equals(two) && !(isKnown(one) && isKnown(two));
        }

        @Override
        public DataFact with(UnaryOperator<Expression> rest) {
            return new Same(rest.apply(when), rest.apply(one), rest.apply(two));
        }
    }

    /** Whether the condition is true, and which value is stored then. */
    record Stored(Expression when, Expression value) implements DataFact {
        @Override
        public List<Expression> expressions() {
            return List.of(when, value);
        }

        @Override
        public boolean isOpen() {
            return !isFalse(when) && !isKnown(value);
        }

        @Override
        public DataFact with(UnaryOperator<Expression> rest) {
            return new Stored(rest.apply(when), rest.apply(value));
        }
    }

    private static boolean isKnown(Expression e) {
        return PartialEvaluation.value(e).isPresent();
    }

    private static boolean isFalse(Expression when) {
        return PartialEvaluation.value(when).equals(Optional.of(new Value.BooleanValue(false)));
    }
}
