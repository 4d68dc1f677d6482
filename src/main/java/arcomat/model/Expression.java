package arcomat.model;

import arcomat.source.Span;

import java.util.List;

/** A typed expression with resolved names. */
public sealed interface Expression {
    Type type();

    Span span();

    record Constant(Value value, Type type, Span span) implements Expression {}

    /** The message on a port; undefined where there is none. */
    record PortRead(Port port, Span span) implements Expression {
        @Override
        public Type type() {
            return port.type();
        }
    }

    /** A variable of the automaton or a constant of the component. */
    record VariableRead(Variable variable, Span span) implements Expression {
        @Override
        public Type type() {
            return variable.type();
        }
    }

    record ParameterRead(Parameter parameter, Span span) implements Expression {
        @Override
        public Type type() {
            return parameter.type();
        }
    }

    /** An attribute of an object; {@code index} counts in {@link Type.ClassType#attributes}. */
    record AttributeRead(Expression object, int index, Type type, Span span)
            implements Expression {}

    /** Whether a port carries what the pattern asks; always defined, also where it is absent. */
    record PortMatches(Port port, Automaton.Pattern pattern, Span span) implements Expression {
        @Override
        public Type type() {
            return new Type.BooleanType();
        }
    }

    record Unary(UnaryOperator operator, Expression operand, Type type, Span span)
            implements Expression {}

    /**
     * Arithmetic, comparison and logic. Numeric operands have one common type: casts are explicit
     * in this tree. {@code PLUS} on strings concatenates.
     */
    record Binary(BinaryOperator operator, Expression left, Expression right, Type type, Span span)
            implements Expression {}

    record Conditional(
            Expression condition, Expression then, Expression otherwise, Type type, Span span)
            implements Expression {}

    record IsIn(Expression element, List<Expression> set, Span span) implements Expression {
        public IsIn {
            set = List.copyOf(set);
        }

        @Override
        public Type type() {
            return new Type.BooleanType();
        }
    }

    /** A numeric conversion with Java's rules. */
    record Cast(Expression operand, Type type, Span span) implements Expression {}

    enum UnaryOperator {
        NOT,
        NEGATE,
        COMPLEMENT
    }

    enum BinaryOperator {
        MULTIPLY("*"),
        DIVIDE("/"),
        REMAINDER("%"),
        PLUS("+"),
        MINUS("-"),
        LESS("<"),
        LESS_OR_EQUAL("<="),
        GREATER(">"),
        GREATER_OR_EQUAL(">="),
        EQUAL("=="),
        NOT_EQUAL("!="),
        AND("&&"),
        OR("||"),
        IMPLIES("implies"),
        EQUIVALENT("<=>");

        private final String sign;

        BinaryOperator(String sign) {
            this.sign = sign;
        }

        /** As models write it. */
        public String sign() {
            return sign;
        }
    }
}
