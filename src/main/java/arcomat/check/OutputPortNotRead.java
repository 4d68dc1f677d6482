package arcomat.check;

import arcomat.source.Span;
import arcomat.symbols.PortSymbol;
import arcomat.symbols.Typed;
import arcomat.symbols.TypedExpression;

/** ARC0308: no expression reads an output port. (RRW14a T6) */
final class OutputPortNotRead implements Check.OnExpression {

    @Override
    public Law law() {
        return Law.error("ARC0308");
    }

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
                        "output port '"
                                + port.name()
                                + "' cannot be read; keep what was sent in a variable")
                .related(port.nameSpan(), "declared as an output here");
    }
}
