package arcomat.symbols.expressions;

import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.RangeType;
import arcomat.symbols.names.TypeSymbol;

/** Which types go together. Erroneous types go with everything: they are reported elsewhere. */
public final class TypeRules {
    private TypeRules() {}

    /**
     * Whether messages of a type may travel to a port of another: connectors convert nothing, so
     * the types are the same up to ranges, and a range fits where it is contained.
     */
    public static boolean fits(TypeSymbol from, TypeSymbol to) {
        if (from.isErroneous() || to.isErroneous()) {
            return true;
        }
        if (!from.base().equals(to.base())) {
            return false;
        }
        if (!(to instanceof RangeType wide)) {
            return true;
        }
        return from instanceof RangeType narrow
                && wide.low() <= narrow.low()
                && narrow.high() <= wide.high();
    }

    /**
     * Whether a value of a type may be assigned, sent or compared as another: as in Java, numbers
     * widen. Ranges are left to the run.
     */
    public static boolean isAssignable(TypeSymbol from, TypeSymbol to) {
        if (from.isErroneous() || to.isErroneous() || from.base().equals(to.base())) {
            return true;
        }
        return from.base() instanceof BuiltinType narrow
                && to.base() instanceof BuiltinType wide
                && widens(narrow, wide);
    }

    /**
     * Whether an expression may be assigned to a type: as its type may, and a constant of at most
     * 32 bits fits every whole number type, and {@code char}, that holds its value (The Java
     * Language Specification, 5.2).
     */
    public static boolean isAssignable(TypedExpression expression, TypeSymbol to) {
        if (isAssignable(expression.type(), to)) {
            return true;
        }
        return expression.type().base() instanceof BuiltinType narrow
                && narrow.isWhole()
                && narrow != BuiltinType.LONG
                && to.base() instanceof BuiltinType wide
                && wide.isWhole()
                && ConstantFolding.computed(expression)
                        .filter(v -> wide.low() <= v && v <= wide.high())
                        .isPresent();
    }

    private static boolean widens(BuiltinType narrow, BuiltinType wide) {
        if (!narrow.isNumber() || !wide.isNumber() || wide == BuiltinType.CHARACTER) {
            return false;
        }
        if (narrow == BuiltinType.CHARACTER) {
            return wide.ordinal() >= BuiltinType.INTEGER.ordinal();
        }
        return narrow.ordinal() <= wide.ordinal();
    }

    /** Whether values of two types may be compared with {@code ==}. */
    static boolean areComparable(TypeSymbol left, TypeSymbol right) {
        return left.isErroneous()
                || right.isErroneous()
                || left.base().equals(right.base())
                || left.isNumeric() && right.isNumeric();
    }

    /** The type in which Java computes with two numbers. */
    static BuiltinType promoted(TypeSymbol left, TypeSymbol right) {
        BuiltinType a = (BuiltinType) left.base();
        BuiltinType b = (BuiltinType) right.base();
        BuiltinType wider = a.ordinal() > b.ordinal() ? a : b;
        return wider.ordinal() < BuiltinType.INTEGER.ordinal() ? BuiltinType.INTEGER : wider;
    }
}
