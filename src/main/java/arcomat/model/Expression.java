package arcomat.model;

import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;

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

        R judged(Judged judged);
    }

    /**
     * One answer for some forms, and one for all others: where most of them, and those to come, are
     * alike.
     *
     * @param <R> what is answered
     */
    interface SomeCases<R> extends Cases<R> {
        /** The answer for each form that has none of its own. */
        R otherwise(Expression expression);

        @Override
        default R constant(Constant constant) {
            return otherwise(constant);
        }

        @Override
        default R portRead(PortRead portRead) {
            return otherwise(portRead);
        }

        @Override
        default R variableRead(VariableRead variableRead) {
            return otherwise(variableRead);
        }

        @Override
        default R parameterRead(ParameterRead parameterRead) {
            return otherwise(parameterRead);
        }

        @Override
        default R attributeRead(AttributeRead attributeRead) {
            return otherwise(attributeRead);
        }

        @Override
        default R portMatches(PortMatches portMatches) {
            return otherwise(portMatches);
        }

        @Override
        default R unary(Unary unary) {
            return otherwise(unary);
        }

        @Override
        default R binary(Binary binary) {
            return otherwise(binary);
        }

        @Override
        default R conditional(Conditional conditional) {
            return otherwise(conditional);
        }

        @Override
        default R isIn(IsIn isIn) {
            return otherwise(isIn);
        }

        @Override
        default R cast(Cast cast) {
            return otherwise(cast);
        }

        @Override
        default R judged(Judged judged) {
            return otherwise(judged);
        }
    }

    Type type();

    Span span();

    /** What it is directly made of, from left to right. */
    List<Expression> operands();

    /** The same of other operands, each made of the one in its place. */
    Expression withOperands(Function<Expression, Expression> rewrite);

    /** An expression without operands. */
    sealed interface Leaf extends Expression {
        @Override
        default List<Expression> operands() {
            return List.of();
        }

        @Override
        default Expression withOperands(Function<Expression, Expression> rewrite) {
            return this;
        }
    }

    /** Rebuilds it from its rewritten operands, then rewrites the result itself. */
    default Expression rewritten(Function<Expression, Expression> rule) {
        return rule.apply(withOperands(operand -> operand.rewritten(rule)));
    }

    /** Visits it and all that it is made of, operands first, from left to right. */
    default void visit(Consumer<Expression> visitor) {
        for (Expression operand : operands()) {
            operand.visit(visitor);
        }
        visitor.accept(this);
    }

    /** The ports whose messages it looks at, from left to right. */
    default List<Port> ports() {
        List<Port> found = new ArrayList<>();
        visit(
                each -> {
                    if (each instanceof PortRead read) {
                        found.add(read.port());
                    } else if (each instanceof PortMatches matches) {
                        found.add(matches.port());
                    }
                });
        return found;
    }

    /** Whether it, or something that it is made of, is a division. */
    default boolean divides() {
        return contains(e -> e instanceof Binary binary && binary.operator().divides());
    }

    /** Whether it, or something that it is made of, is what is asked for. */
    default boolean contains(Predicate<Expression> wanted) {
        if (wanted.test(this)) {
            return true;
        }
        for (Expression operand : operands()) {
            if (operand.contains(wanted)) {
                return true;
            }
        }
        return false;
    }

    private static List<Expression> all(
            List<Expression> list, Function<Expression, Expression> rewrite) {
        return list.stream().map(rewrite).toList();
    }

    record Constant(Value value, Type type, Span span) implements Leaf {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.constant(this);
        }
    }

    /** The message on a port; undefined where there is none. */
    record PortRead(Port port, Span span) implements Leaf {
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
    record VariableRead(Variable variable, Span span) implements Leaf {
        @Override
        public Type type() {
            return variable.type();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.variableRead(this);
        }
    }

    record ParameterRead(Parameter parameter, Span span) implements Leaf {
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

        @Override
        public List<Expression> operands() {
            return List.of(object);
        }

        @Override
        public Expression withOperands(Function<Expression, Expression> rewrite) {
            return new AttributeRead(rewrite.apply(object), index, type, span);
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

        @Override
        public List<Expression> operands() {
            return pattern.values();
        }

        @Override
        public Expression withOperands(Function<Expression, Expression> rewrite) {
            return pattern instanceof Automaton.OneOf oneOf
                    ? new PortMatches(port, new Automaton.OneOf(all(oneOf.values(), rewrite)), span)
                    : this;
        }
    }

    record Unary(UnaryOperator operator, Expression operand, Type type, Span span)
            implements Expression {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.unary(this);
        }

        @Override
        public List<Expression> operands() {
            return List.of(operand);
        }

        @Override
        public Expression withOperands(Function<Expression, Expression> rewrite) {
            return new Unary(operator, rewrite.apply(operand), type, span);
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

        @Override
        public List<Expression> operands() {
            return List.of(left, right);
        }

        @Override
        public Expression withOperands(Function<Expression, Expression> rewrite) {
            return new Binary(operator, rewrite.apply(left), rewrite.apply(right), type, span);
        }
    }

    record Conditional(
            Expression condition, Expression then, Expression otherwise, Type type, Span span)
            implements Expression {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.conditional(this);
        }

        @Override
        public List<Expression> operands() {
            return List.of(condition, then, otherwise);
        }

        @Override
        public Expression withOperands(Function<Expression, Expression> rewrite) {
            return new Conditional(
                    rewrite.apply(condition),
                    rewrite.apply(then),
                    rewrite.apply(otherwise),
                    type,
                    span);
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

        @Override
        public List<Expression> operands() {
            return Stream.concat(Stream.of(element), set.stream()).toList();
        }

        @Override
        public Expression withOperands(Function<Expression, Expression> rewrite) {
            return new IsIn(rewrite.apply(element), all(set, rewrite), span);
        }
    }

    /** A numeric conversion with Java's rules. */
    record Cast(Expression operand, Type type, Span span) implements Expression {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.cast(this);
        }

        @Override
        public List<Expression> operands() {
            return List.of(operand);
        }

        @Override
        public Expression withOperands(Function<Expression, Expression> rewrite) {
            return new Cast(rewrite.apply(operand), type, span);
        }
    }

    /**
     * That a condition which nests deeply has a value, which is true. It has a value itself, and
     * each part of the condition is looked at once.
     */
    record Judged(Valuation valuation, Span span) implements Expression {
        @Override
        public Type type() {
            return new Type.BooleanType();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.judged(this);
        }

        @Override
        public List<Expression> operands() {
            return valuation.expressions();
        }

        @Override
        public Expression withOperands(Function<Expression, Expression> rewrite) {
            return new Judged(valuation.with(rewrite), span);
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

        /** Whether there is no result where the right operand is zero. */
        public boolean divides() {
            return this == DIVIDE || this == REMAINDER;
        }

        /** Whether one operand may decide alone. */
        public boolean isLazy() {
            return this == AND || this == OR || this == IMPLIES;
        }
    }
}
