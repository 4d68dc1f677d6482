package arcomat.semantics.statement;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Variable;

import java.util.List;
import java.util.function.UnaryOperator;

/** A value that a variable or a port stands for at some place of statements. */
sealed interface HeldValue {
    HeldValue CELL = new Cell();

    /** The same with other expressions. */
    HeldValue rewritten(UnaryOperator<Expression> rewrite);

    /** Whether an expression in it reads a variable. */
    boolean reads(String variable);

    /** What has been computed and stands in its cell; of a port also that nothing is sent. */
    record Cell() implements HeldValue {
        @Override
        public HeldValue rewritten(UnaryOperator<Expression> rewrite) {
            return this;
        }

        @Override
        public boolean reads(String variable) {
            return false;
        }
    }

    /**
     * What is computed once it is needed: it may go wrong, or read what is not there.
     *
     * @param present two-valued, that there is what it reads
     */
    record Later(Automaton.Emission emission, Expression present) implements HeldValue {
        static Later of(Expression value, Expression present) {
            return new Later(new Automaton.Messages(List.of(value)), present);
        }

        Expression value() {
            return emission.values().get(0);
        }

        @Override
        public HeldValue rewritten(UnaryOperator<Expression> rewrite) {
            return emission instanceof Automaton.Messages messages
                    ? new Later(
                            new Automaton.Messages(
                                    messages.values().stream().map(rewrite).toList()),
                            present)
                    : this;
        }

        @Override
        public boolean reads(String variable) {
            return emission.values().stream().anyMatch(value -> reads(value, variable));
        }

        private static boolean reads(Expression value, String variable) {
            return value.contains(
                    e ->
                            e instanceof Expression.VariableRead read
                                    && read.variable().name().equals(variable));
        }
    }

    /** One of two, as a variable says that was set where the statements chose. */
    record Either(Variable chosen, HeldValue then, HeldValue otherwise) implements HeldValue {
        @Override
        public HeldValue rewritten(UnaryOperator<Expression> rewrite) {
            return new Either(chosen, then.rewritten(rewrite), otherwise.rewritten(rewrite));
        }

        @Override
        public boolean reads(String variable) {
            return then.reads(variable) || otherwise.reads(variable);
        }
    }
}
