package arcomat.check.behaviour.expression;

import arcomat.check.behaviour.item.Items;
import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ExpressionProblem;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.ValueSymbol;

import java.util.Optional;

/** ARC0309: initial outputs and initial values do not depend on input. */
public final class InitialReadsNoInput implements Check.OnExpression {

    @Override
    public void check(Typed expression, Context context, Findings findings) {
        if (context.side().filter(ItemSymbol.Side.INITIAL::equals).isPresent()) {
            Expressions.portsRead(
                    expression,
                    (place, port) -> {
                        if (port.isInput()) {
                            report(place.span(), port, findings);
                        }
                    });
        }
        for (ExpressionProblem problem : expression.problems()) {
            readTooEarly(problem, context)
                    .ifPresent(value -> report(problem.span(), value, findings));
        }
    }

    /**
     * What an unknown name in an initial value means once the automaton runs. Initial values are
     * the only expressions of an automaton that stand outside of blocks and transitions.
     */
    static Optional<ValueSymbol> readTooEarly(ExpressionProblem problem, Context context) {
        boolean initialValue =
                context.automaton().isPresent()
                        && context.transition().isEmpty()
                        && context.side().isEmpty();
        if (!initialValue || problem.kind() != ExpressionProblem.Kind.UNKNOWN_NAME) {
            return Optional.empty();
        }
        String name = problem.span().text();
        int dot = name.indexOf('.');
        String first = dot < 0 ? name : name.substring(0, dot);
        return context.automaton().get().scope().value(first);
    }

    private static void report(Span place, ValueSymbol value, Findings findings) {
        String reason =
                value instanceof PortSymbol
                        ? " before the first slice"
                        : " where initial values are set";
        findings.report(
                        place,
                        "%s cannot be read%s; write a constant or a parameter",
                        Items.words(value),
                        reason)
                .related(value.nameSpan(), "declared here");
    }
}
