package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Fix.TextEdit;
import arcomat.source.Span;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.RangeType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnsupportedType;
import arcomat.tree.TypeReference;

import java.util.List;

/** ARC0332: a range has two constant ends in order, on a type of whole numbers. */
public final class RangeWellFormed implements Check.OnType {

    @Override
    public void check(TypeReference type, Context context, Findings findings) {
        if (type.range().isPresent()) {
            context.resolve(type)
                    .found()
                    .ifPresent(resolved -> check(type.range().get(), resolved, findings));
        }
    }

    private static void check(TypeReference.Range range, TypeSymbol resolved, Findings findings) {
        if (resolved instanceof RangeType type) {
            checkEnds(range, type, findings);
        } else if (resolved instanceof UnsupportedType type) {
            findings.report(range, type.advice());
        }
    }

    private static void checkEnds(TypeReference.Range range, RangeType type, Findings findings) {
        BuiltinType carrier = type.carrier();
        if (type.low() > type.high()) {
            findings.report(range, "the range is empty; write the lower end first")
                    .fix(exchange(range));
        } else if (type.low() < carrier.low() || type.high() > carrier.high()) {
            findings.report(
                    range,
                    "%s holds numbers from %s to %s; narrow the range%s",
                    carrier,
                    carrier.low(),
                    carrier.high(),
                    carrier == BuiltinType.LONG ? "" : " or use a wider type");
        }
    }

    private static Fix exchange(TypeReference.Range range) {
        Span low = range.low().span();
        Span high = range.high().span();
        return new Fix(
                "Exchange the ends",
                List.of(new TextEdit(low, high.text()), new TextEdit(high, low.text())));
    }
}
