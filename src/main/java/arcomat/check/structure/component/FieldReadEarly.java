package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.symbols.expressions.VariableSymbol;

/**
 * ARC0141: what is computed once, before anything runs, reads no variable that changes: initial
 * values, and arguments of parts.
 */
public final class FieldReadEarly implements Check.OnExpression {

    @Override
    public void check(Typed expression, Context context, Findings findings) {
        if (isEarly(context)) {
            expression.variablesRead().forEach(read -> check(read, context, findings));
        }
    }

    /** Guards and cells stand in transitions and on sides, initial values and arguments do not. */
    static boolean isEarly(Context context) {
        return context.transition().isEmpty() && context.side().isEmpty();
    }

    private static void check(
            TypedExpression.VariableRead read, Context context, Findings findings) {
        VariableSymbol variable = read.variable();
        if (context.component().filter(each -> each.fields().contains(variable)).isPresent()) {
            findings.report(
                            read.node(),
                            "'%s' changes while the component runs, and this is computed before;"
                                    + " read a constant or a parameter",
                            variable.name())
                    .related(variable.nameSpan(), "an automaton writes this variable");
        }
    }
}
