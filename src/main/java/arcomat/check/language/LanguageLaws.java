package arcomat.check.language;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.Needs.NOTHING;

import arcomat.check.law.Law;
import arcomat.check.law.Law.Needs;

import java.util.List;

/** One line for each code of the tool's own languages, in alphabetical order of the names. */
public final class LanguageLaws {
    public static final List<Law> LAWS =
            List.of(
                    law("TableCellFits", "ARC0336", NOTHING),
                    law("TableColumnsExist", "ARC0334", NAMES),
                    law("TableRowWidth", "ARC0335", ALL));

    private LanguageLaws() {}

    private static Law law(String name, String code, Needs needs) {
        return Law.error(code, new ToldByLanguage(name, code)).needing(needs);
    }
}
