package arcomat.model;

import arcomat.source.Span;

import java.util.List;

/** A typed expression with resolved names. */
public sealed interface Expression {
    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R constant(Constant constant);

        R portRead(PortRead portRead);

        R variableRead(VariableRead variableRead);

        R parameterRead(ParameterRead parameterRead);

        R attributeRead(AttributeRead attributeRead);

        R portMatches(PortMatches portMatches);

        R unary(Unary unary);

        R binary(Binary binary);

        R conditional(Conditional conditional);

        R isIn(IsIn isIn);

        R cast(Cast cast);
    }

    Type type();

    Span span();

    record Constant(Value value, Type type, Span span) implements Expression {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.constant(this);
        }
    }

    /** The message on a port; undefined where there is none. */
    record PortRead(Port port, Span span) implements Expression {
        @Override
        public Type type() {
            return port.type();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.portRead(this);
        }
    }

    /** A variable of the automaton or a constant of the component. */
    record VariableRead(Variable variable, Span span) implements Expression {
        @Override
        public Type type() {
            return variable.type();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.variableRead(this);
        }
    }

    record ParameterRead(Parameter parameter, Span span) implements Expression {
        @Override
        public Type type() {
            return parameter.type();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.parameterRead(this);
        }
    }

    /** An attribute of an object; {@code index} counts in {@link Type.ClassType#attributes}. */
    record AttributeRead(Expression object, int index, Type type, Span span) implements Expression {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.attributeRead(this);
        }
    }

    /** Whether a port carries what the pattern asks; always defined, also where it is absent. */
    record PortMatches(Port port, Automaton.Pattern pattern, Span span) implements Expression {
        @Override
        public Type type() {
            return new Type.BooleanType();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.portMatches(this);
        }
    }

    record Unary(UnaryOperator operator, Expression operand, Type type, Span span)
            implements Expression {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.unary(this);
        }
    }

    /**
     * Arithmetic, comparison and logic. Numeric operands have one common type: casts are explicit
     * in this tree. {@code PLUS} on strings concatenates.
     */
    record Binary(BinaryOperator operator, Expression left, Expression right, Type type, Span span)
            implements Expression {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.binary(this);
        }
    }

    record Conditional(
            Expression condition, Expression then, Expression otherwise, Type type, Span span)
            implements Expression {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.conditional(this);
        }
    }

    record IsIn(Expression element, List<Expression> set, Span span) implements Expression {
        public IsIn {
            set = List.copyOf(set);
        }

        @Override
        public Type type() {
            return new Type.BooleanType();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.isIn(this);
        }
    }

    /** A numeric conversion with Java's rules. */
    record Cast(Expression operand, Type type, Span span) implements Expression {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.cast(this);
        }
    }

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
