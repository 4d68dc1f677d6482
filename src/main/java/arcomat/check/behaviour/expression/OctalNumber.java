package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.symbols.names.LiteralValues;
import arcomat.tree.Expression.Literal;
import arcomat.tree.Unit;
import arcomat.tree.Unit.Spelling;

import java.util.OptionalLong;

/** ARC0348: no number begins with 0 and means another one than it would without. */
public final class OctalNumber implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        unit.spellings().stream()
                .filter(each -> each.kind() == Spelling.Kind.OCTAL)
                .forEach(each -> check(each, findings));
    }

    private static void check(Spelling number, Findings findings) {
        OptionalLong octal = value(number, number.span().text());
        OptionalLong decimal = value(number, number.span().text().replaceFirst("^0[0_]*(?=.)", ""));
        if (octal.isPresent() && !octal.equals(decimal)) {
            report(number, octal.getAsLong(), findings);
        }
    }

    private static OptionalLong value(Spelling number, String text) {
        boolean isLong = text.endsWith("l") || text.endsWith("L");
        Literal.Kind kind = isLong ? Literal.Kind.LONG : Literal.Kind.INT;
        return LiteralValues.wholeNumber(new Literal(number.span(), kind, text), false);
    }

    private static void report(Spelling number, long value, Findings findings) {
        String written = number.span().text();
        String ending = Character.isLetter(written.charAt(written.length() - 1)) ? "L" : "";
        findings.report(
                        number,
                        "'%s' begins with 0 and is octal, as in Java: it is %s; write %s, or leave"
                                + " out the 0",
                        written,
                        value,
                        value + ending)
                .fix(
                        Fix.replace(
                                "Replace '" + written + "' by '" + value + ending + "'",
                                number.span(),
                                value + ending));
    }
}
