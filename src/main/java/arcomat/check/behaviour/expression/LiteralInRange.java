package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.symbols.expressions.ConstantFolding;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.names.RangeType;
import arcomat.symbols.names.TypeSymbol;

/** ARC0322: a number that is sent, stored, waited for or passed on lies in the range there. */
public final class LiteralInRange implements Check.OnValue {

    /** A range that is reversed has a finding already. */
    @Override
    public void check(Typed value, TypeSymbol type, Context context, Findings findings) {
        if (type instanceof RangeType range && range.low() <= range.high()) {
            ConstantFolding.computed(value.expression())
                    .filter(number -> !range.contains(number))
                    .ifPresent(number -> report(value, number, range, findings));
        }
    }

    private static void report(Typed value, long number, RangeType range, Findings findings) {
        findings.report(
                value.expression().node(),
                "%s lies outside of %s; write a number from %s to %s or widen the range",
                number,
                range.text(),
                range.low(),
                range.high());
    }
}
