package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.tree.Unit;
import arcomat.tree.Unit.Spelling;

/**
 * ARC0331: a literal has a value of its type. Numbers are looked at wherever they stand, as sizes
 * and counts are no expressions.
 */
public final class LiteralFits extends ProblemLaw implements Check.OnUnit {

    LiteralFits() {
        super(Kind.LITERAL_OVERFLOW);
    }

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        unit.spellings().stream()
                .filter(each -> each.kind() == Spelling.Kind.NOT_OCTAL)
                .forEach(each -> report(each, findings));
    }

    private static void report(Spelling number, Findings findings) {
        String written = number.span().text();
        String decimal = written.replaceFirst("^[0_]+", "");
        findings.report(
                        number,
                        "'%s' begins with 0 and is octal, as in Java, where there is no digit 8 or"
                                + " 9; write %s",
                        written,
                        decimal)
                .fix(
                        Fix.replace(
                                "Replace '" + written + "' by '" + decimal + "'",
                                number.span(),
                                decimal));
    }
}
