package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.source.Span;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;

/** ARC0308: no expression reads an output port. (RRW14a T6) */
public final class OutputPortNotRead implements Check.OnExpression {

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        typed.expression().walk(part -> check(part, findings));
    }

    private static void check(TypedExpression part, Findings findings) {
        Expressions.portRead(part)
                .filter(PortSymbol::isOutput)
                .ifPresent(port -> report(part.node().span(), port, findings));
    }

    private static void report(Span place, PortSymbol port, Findings findings) {
        findings.report(
                        place,
                        "output port '%s' cannot be read; keep what was sent in a variable",
                        port.name())
                .related(port.nameSpan(), "declared as an output here");
    }
}
