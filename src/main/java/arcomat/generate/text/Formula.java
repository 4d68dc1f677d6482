package arcomat.generate.text;

import arcomat.generate.language.Text;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** A two-valued condition in a form that can be compared and simplified. */
public sealed interface Formula {
    Formula TRUE = new Row(true, List.of());
    Formula FALSE = new Row(false, List.of());

    static Formula of(boolean truth) {
        return truth ? TRUE : FALSE;
    }

    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    record Cases<R>(
            Function<Carries, R> carries,
            Function<Is, R> is,
            Function<Test, R> test,
            Function<Not, R> not,
            Function<Row, R> row,
            Function<Judged, R> judged) {}

    /** A port carries a message, or carries none. */
    record Carries(Port port, boolean something) implements Formula {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.carries().apply(this);
        }
    }

    /**
     * The message on a port is a value, or is another one.
     *
     * @param constant the value where it is a constant
     */
    record Is(Port port, boolean equal, Optional<Value> constant, Text text, Text negated)
            implements Formula {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.is().apply(this);
        }

        /** The other truth value, or another message; not that there is none. */
        Is negation() {
            return constant.isPresent() && constant.get() instanceof Value.BooleanValue truth
                    ? new Is(
                            port,
                            true,
                            Optional.of(new Value.BooleanValue(!truth.value())),
                            negated,
                            text)
                    : new Is(port, !equal, constant, negated, text);
        }
    }

    /**
     * Any other test.
     *
     * @param fact what it asks for, in the same words as tests that ask for the opposite
     * @param so whether it holds where the fact does, or where it does not
     * @param mayFail whether it may go wrong instead of saying anything
     * @param bounds what the test says about one whole number, if it says something like that
     */
    record Test(Text text, String fact, boolean so, boolean mayFail, Optional<Bounds> bounds)
            implements Formula {
        /** One that has no opposite. */
        public static Test of(Text text, boolean mayFail) {
            return new Test(text, text.text(), true, mayFail, Optional.empty());
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.test().apply(this);
        }
    }

    record Not(Formula operand) implements Formula {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.not().apply(this);
        }
    }

    /** Of the operands all hold, or at least one does; of none that is true, or false. */
    record Row(boolean all, List<Formula> operands) implements Formula {
        /** One operand alone is no row. */
        public static Formula of(boolean all, List<Formula> operands) {
            return operands.size() == 1 ? operands.get(0) : new Row(all, List.copyOf(operands));
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.row().apply(this);
        }
    }

    /**
     * A condition that nests deeply is true.
     *
     * @param place where it goes wrong if it does
     */
    record Judged(Expression.Judged condition, String place) implements Formula {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.judged().apply(this);
        }
    }

    /** A number is at least {@code low} and at most {@code high}. */
    record Bounds(String number, long low, long high) {
        boolean excludes(Bounds other) {
            return number.equals(other.number) && (high < other.low || other.high < low);
        }
    }

    /** The operands of a conjunction; what is none is one alone. */
    default List<Formula> conjuncts() {
        return this instanceof Row row && row.all() ? row.operands() : List.of(this);
    }

    /** Whether looking at it may go wrong instead of saying anything. */
    default boolean mayFail() {
        return match(
                new Cases<>(
                        carries -> false,
                        is -> false,
                        Test::mayFail,
                        not -> not.operand().mayFail(),
                        row -> row.operands().stream().anyMatch(Formula::mayFail),
                        judged -> RuntimeChecks.dividesAnywhere(judged.condition())));
    }

    /** The conjuncts that are looked at before anything may go wrong. */
    default Formula beforeFailing() {
        return Row.of(true, conjuncts().stream().takeWhile(each -> !each.mayFail()).toList());
    }
}
