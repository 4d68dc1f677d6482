package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.tree.Unit;
import arcomat.tree.Unit.Spelling;

/** ARC0220: the letters of a name are of one script, so that no two names look alike. */
public final class OneScriptPerName implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        unit.spellings().stream()
                .filter(each -> each.kind() == Spelling.Kind.MIXED_SCRIPTS)
                .forEach(each -> report(each, findings));
    }

    private static void report(Spelling name, Findings findings) {
        findings.report(
                name,
                "'%s' has letters of several scripts, such as a Latin and a Cyrillic a, which look"
                        + " alike; write the name in one",
                name.span().text());
    }
}
