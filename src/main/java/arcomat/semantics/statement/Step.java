package arcomat.semantics.statement;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;

import java.util.List;

/** A step of a {@link Procedure}. All that it computes has a value at its place. */
public sealed interface Step {
    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R declare(Declare declare);

        R set(Set set);

        R keep(Keep keep);

        R emit(Emit emit);

        R choose(Choose choose);

        R need(Need need);

        R count(Count count);
    }

    /** A local variable, known to the end of the steps in which it stands. */
    record Declare(Variable cell, Expression value) implements Step {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.declare(this);
        }
    }

    /** A variable gets a value. */
    record Set(Variable cell, Expression value) implements Step {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.set(this);
        }
    }

    /**
     * A variable of the automaton gets the value that it keeps, which has to be in its range.
     *
     * @param wanted the type with the range
     * @param name in the model
     */
    record Keep(Variable cell, Expression value, Type wanted, String name) implements Step {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.keep(this);
        }
    }

    /** A port carries a message, or none. */
    record Emit(Port port, Automaton.Emission emission) implements Step {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.emit(this);
        }
    }

    /** Some steps where a two-valued condition holds, and others where it does not. */
    record Choose(Expression condition, List<Step> then, List<Step> otherwise) implements Step {
        public Choose {
            then = List.copyOf(then);
            otherwise = List.copyOf(otherwise);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.choose(this);
        }
    }

    /** Nothing is done at all unless a two-valued condition holds. */
    record Need(Expression condition) implements Step {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.need(this);
        }
    }

    /** The way that is gone has a number that is larger by so much. */
    record Count(int more) implements Step {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.count(this);
        }
    }
}
