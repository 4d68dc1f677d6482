package arcomat.symbols.expressions;

import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.symbols.names.UnsupportedType;
import arcomat.tree.Expression;

/** Which casts there are: between number types, and to the type that a value has anyway. */
final class CastTyping {
    private CastTyping() {}

    /** The type after a cast; unknown, and reported, where there is no such cast. */
    static TypeSymbol target(
            Expression.Cast node, TypeSymbol from, ValueScope scope, ProblemSink problems) {
        Resolution<TypeSymbol> resolution = scope.type(node.type());
        TypeSymbol target = resolution.found().orElse(UnknownType.UNKNOWN);
        if (resolution.isUnknown()) {
            problems.report(
                    ExpressionProblem.Kind.UNKNOWN_NAME,
                    node,
                    "there is no type '" + node.type().name() + "'");
        } else if (resolution.isAmbiguous()) {
            problems.report(
                    ExpressionProblem.Kind.AMBIGUOUS_NAME,
                    node,
                    "several types could be meant by '"
                            + node.type().name()
                            + "'; qualify it fully");
        } else if (target instanceof UnsupportedType unsupported) {
            problems.report(
                    ExpressionProblem.Kind.UNSUPPORTED_EXPRESSION,
                    node,
                    "no cast to " + unsupported.text() + "; " + unsupported.advice());
        } else if (!converts(from, target)) {
            problems.report(
                    ExpressionProblem.Kind.CAST,
                    node,
                    "a value of type "
                            + from.text()
                            + " cannot be cast to "
                            + target.text()
                            + "; casts convert between number types");
            return UnknownType.UNKNOWN;
        }
        return target;
    }

    private static boolean converts(TypeSymbol from, TypeSymbol target) {
        boolean numbers = target instanceof BuiltinType && target.isNumeric() && from.isNumeric();
        return numbers || from.isErroneous() || target.isErroneous() || target.equals(from.base());
    }
}
