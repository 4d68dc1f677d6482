package arcomat.symbols.expressions;

import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Expression;

import java.util.List;
import java.util.function.Consumer;

/** An expression with resolved names and types. */
public sealed interface TypedExpression {
    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R literal(Literal literal);

        R constant(Constant constant);

        R portRead(PortRead portRead);

        R variableRead(VariableRead variableRead);

        R parameterRead(ParameterRead parameterRead);

        R attributeRead(AttributeRead attributeRead);

        R unary(Unary unary);

        R binary(Binary binary);

        R conditional(Conditional conditional);

        R membership(Membership membership);

        R absence(Absence absence);

        R cast(Cast cast);

        R newObject(NewObject newObject);

        R erroneous(Erroneous erroneous);
    }

    TypeSymbol type();

    /** What was written. */
    Expression node();

    /** The direct parts, in text order. */
    List<TypedExpression> parts();

    /** Visits this expression and everything in it. */
    default void walk(Consumer<? super TypedExpression> visitor) {
        visitor.accept(this);
        for (TypedExpression part : parts()) {
            part.walk(visitor);
        }
    }

    /** An expression without parts. */
    sealed interface Leaf extends TypedExpression {
        @Override
        default List<TypedExpression> parts() {
            return List.of();
        }

        @Override
        default void walk(Consumer<? super TypedExpression> visitor) {
            visitor.accept(this);
        }
    }

    /**
     * @param value a Boolean, Long, Double, Character or String; a Long for every whole number
     */
    record Literal(Expression node, Object value, TypeSymbol type) implements Leaf {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.literal(this);
        }
    }

    /** A constant of an enumeration; {@code qualified} tells whether the type was written. */
    record Constant(Expression node, EnumSymbol type, int ordinal, boolean qualified)
            implements Leaf {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.constant(this);
        }
    }

    /** The message on a port, of either direction: whether it may be read is for the checks. */
    record PortRead(Expression node, PortSymbol port) implements Leaf {
        @Override
        public TypeSymbol type() {
            return port.type();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.portRead(this);
        }
    }

    record VariableRead(Expression node, VariableSymbol variable) implements Leaf {
        @Override
        public TypeSymbol type() {
            return variable.type();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.variableRead(this);
        }
    }

    record ParameterRead(Expression node, ParameterSymbol parameter) implements Leaf {
        @Override
        public TypeSymbol type() {
            return parameter.type();
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.parameterRead(this);
        }
    }

    /** {@code object.attribute}; {@code index} counts in {@link ClassSymbol#attributes}. */
    record AttributeRead(Expression node, TypedExpression object, int index, TypeSymbol type)
            implements TypedExpression {
        @Override
        public List<TypedExpression> parts() {
            return List.of(object);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.attributeRead(this);
        }
    }

    record Unary(Expression.Unary node, TypedExpression operand, TypeSymbol type)
            implements TypedExpression {
        @Override
        public List<TypedExpression> parts() {
            return List.of(operand);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.unary(this);
        }
    }

    /**
     * @param operandType the type in which the operands are computed or compared
     */
    record Binary(
            Expression.Binary node,
            TypedExpression left,
            TypedExpression right,
            TypeSymbol operandType,
            TypeSymbol type)
            implements TypedExpression {
        @Override
        public List<TypedExpression> parts() {
            return List.of(left, right);
        }

        @Override
        public void walk(Consumer<? super TypedExpression> visitor) {
            visitor.accept(this);
            left.walk(visitor);
            right.walk(visitor);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.binary(this);
        }
    }

    record Conditional(
            Expression.Conditional node,
            TypedExpression condition,
            TypedExpression then,
            TypedExpression otherwise,
            TypeSymbol type)
            implements TypedExpression {
        @Override
        public List<TypedExpression> parts() {
            return List.of(condition, then, otherwise);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.conditional(this);
        }
    }

    /**
     * @param operandType the type in which element and set are compared
     */
    record Membership(
            Expression.Membership node,
            TypedExpression element,
            List<TypedExpression> set,
            TypeSymbol operandType)
            implements TypedExpression {
        public Membership {
            set = List.copyOf(set);
        }

        @Override
        public TypeSymbol type() {
            return BuiltinType.BOOLEAN;
        }

        @Override
        public List<TypedExpression> parts() {
            List<TypedExpression> all = new java.util.ArrayList<>();
            all.add(element);
            all.addAll(set);
            return all;
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.membership(this);
        }
    }

    /** {@code port == --} or {@code port != --}: asks, but does not read a message. */
    record Absence(Expression.Absence node, PortSymbol port) implements Leaf {
        @Override
        public TypeSymbol type() {
            return BuiltinType.BOOLEAN;
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.absence(this);
        }
    }

    record Cast(Expression.Cast node, TypedExpression operand, TypeSymbol type)
            implements TypedExpression {
        @Override
        public List<TypedExpression> parts() {
            return List.of(operand);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.cast(this);
        }
    }

    /** {@code Cup(5)}, in stream tests only; of a class, or of a type that nobody looks into. */
    record NewObject(Expression.Call node, TypeSymbol type, List<TypedExpression> arguments)
            implements TypedExpression {
        public NewObject {
            arguments = List.copyOf(arguments);
        }

        @Override
        public List<TypedExpression> parts() {
            return arguments;
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.newObject(this);
        }
    }

    /** Something that does not resolve, with the parts that do. */
    record Erroneous(Expression node, List<TypedExpression> parts) implements TypedExpression {
        public Erroneous {
            parts = List.copyOf(parts);
        }

        @Override
        public TypeSymbol type() {
            return UnknownType.UNKNOWN;
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.erroneous(this);
        }
    }
}
