package arcomat.check.behaviour.table;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.error;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class TableLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0336", new TableCellFits()),
                    error("ARC0334", new TableColumnsExist()).needing(NAMES),
                    error("ARC0335", new TableRowWidth()).needing(ALL));

    private TableLaws() {}
}
