package arcomat.symbols.expressions;

import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;

import java.util.function.BiFunction;

/** Gives names and types to expressions. */
public final class ExpressionTyping {
    private ExpressionTyping() {}

    /**
     * Types an expression.
     *
     * @param expected the type of the place it stands in: a bare name that is no value is looked up
     *     among the constants of an expected enumeration. Unknown where nothing is expected.
     *     Whether the result fits is for the caller to ask.
     */
    public static Typed type(Expression expression, ValueScope scope, TypeSymbol expected) {
        return type(expression, scope, expected, false);
    }

    /** Types expressions at one place. */
    public static BiFunction<Expression, TypeSymbol, Typed> at(ValueScope scope) {
        return (expression, expected) -> type(expression, scope, expected);
    }

    /** Types a message of a stream test, where objects may be written as {@code Cup(5)}. */
    public static Typed message(Expression expression, ValueScope scope, TypeSymbol expected) {
        return type(expression, scope, expected, true);
    }

    private static Typed type(
            Expression expression, ValueScope scope, TypeSymbol expected, boolean objects) {
        Problems problems = new Problems();
        FormTyping forms = new FormTyping(scope, objects, problems, expected);
        return new Typed(forms.type(expression, expected), problems.found(), problems.unfolded());
    }
}
