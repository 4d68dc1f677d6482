package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Name;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** ARC0334: the columns of a table are ports of the right direction, each once. */
public final class TableColumnsExist implements Check.OnTable {

    @Override
    public void check(TableSymbol table, Context context, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        table.inputs().forEach(column -> check(column, table, seen, findings));
        table.outputs().forEach(column -> check(column, table, seen, findings));
    }

    private static void check(
            TableSymbol.Column column,
            TableSymbol table,
            Map<String, Name> seen,
            Findings findings) {
        Name name = column.node();
        if (column.port().isEmpty()) {
            reportUnknown(column, table, findings);
        } else if (column.port().get().isInput() != column.input()) {
            reportDirection(name, column.port().get(), findings);
        } else if (seen.putIfAbsent(name.text(), name) != null) {
            findings.report(name, "'%s' is a column already; remove one", name)
                    .related(seen.get(name.text()), "the other column");
        }
    }

    private static void reportUnknown(
            TableSymbol.Column column, TableSymbol table, Findings findings) {
        Name name = column.node();
        List<String> candidates =
                table.component().ports().stream()
                        .filter(port -> port.isInput() == column.input())
                        .map(PortSymbol::name)
                        .toList();
        findings.reportUnknown(
                name.span(),
                "component '" + table.component().name() + "' has no port '" + name + "'",
                name.text(),
                candidates,
                "declare it, or drop the column");
    }

    private static void reportDirection(Name name, PortSymbol port, Findings findings) {
        findings.report(
                        name,
                        port.isInput()
                                ? "'" + name + "' is an input port; list it behind 'in'"
                                : "'" + name + "' is an output port; list it behind 'out'")
                .related(port.nameSpan(), "declared here");
    }
}
