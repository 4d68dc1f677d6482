package arcomat.table;

import arcomat.guest.BehaviourLanguage.Written;
import arcomat.guest.Meaning;
import arcomat.guest.Vicinity;
import arcomat.guest.Vicinity.Kind;
import arcomat.guest.Vicinity.Value;
import arcomat.source.Span;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** ARC0334: the columns of a table are ports of the right direction, each once. */
final class TableColumns {
    static final String CODE = "ARC0334";

    private final Written table;
    private final Vicinity around;
    private final Map<String, Span> seen = new HashMap<>();

    TableColumns(Written table, Vicinity around) {
        this.table = table;
        this.around = around;
    }

    /**
     * Those of one side.
     *
     * @param meaning takes what is wrong with them
     */
    List<TableColumn> of(List<Part> names, Kind side, Meaning meaning) {
        List<TableColumn> columns = new ArrayList<>();
        for (Part name : names) {
            Span place = table.part(name.start(), name.end());
            columns.add(new TableColumn(place, isPort(name(name.text()), place, side, meaning)));
        }
        return columns;
    }

    /** Elements of arrays have names with a plain number, however that is written. */
    private static String name(String written) {
        int open = written.indexOf('[');
        if (open < 0) {
            return written;
        }
        String digits = written.substring(open + 1, written.length() - 1).replace("_", "");
        String prefix = digits.length() > 1 ? digits.substring(0, 2).toLowerCase(Locale.ROOT) : "";
        BigInteger index =
                switch (prefix) {
                    case "0x" -> new BigInteger(digits.substring(2), 16);
                    case "0b" -> new BigInteger(digits.substring(2), 2);
                    default -> new BigInteger(digits);
                };
        return written.substring(0, open) + "[" + index + "]";
    }

    private boolean isPort(String name, Span place, Kind side, Meaning meaning) {
        Optional<Value> port = around.value(name).filter(TableColumns::isPort);
        if (port.isEmpty()) {
            unknown(name, place, side, meaning);
            return false;
        }
        meaning.names(place);
        if (port.get().kind() != side) {
            String direction =
                    side == Kind.OUTPUT
                            ? "'%s' is an input port; list it behind 'in'"
                            : "'%s' is an output port; list it behind 'out'";
            meaning.problem(CODE, place, direction.formatted(name))
                    .related(port.get().declared(), "declared here");
            return false;
        }
        Span other = seen.putIfAbsent(name, place);
        if (other != null) {
            meaning.problem(CODE, place, "'" + name + "' is a column already; remove one")
                    .related(other, "the other column");
        }
        return other == null;
    }

    private static boolean isPort(Value value) {
        return value.kind() == Kind.INPUT || value.kind() == Kind.OUTPUT;
    }

    private void unknown(String name, Span place, Kind side, Meaning meaning) {
        meaning.unknown(
                CODE,
                place,
                "component '" + around.component() + "' has no port '" + name + "'",
                name,
                around.of(side).stream().map(Value::name).toList(),
                "declare it, or drop the column");
    }
}
