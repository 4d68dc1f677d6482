package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.symbols.expressions.Typed;

/** ARC0308: no expression reads an output port. (RRW14a T6) */
public final class OutputPortNotRead implements Check.OnExpression {

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        Expressions.portsRead(
                typed,
                (place, port) -> {
                    if (port.isOutput()) {
                        findings.report(
                                        place,
                                        "output port '%s' cannot be read; keep what was sent in a"
                                                + " variable",
                                        port.name())
                                .related(port.nameSpan(), "declared as an output here");
                    }
                });
    }
}
