package arcomat.table;

import arcomat.guest.BehaviourLanguage.Written;
import arcomat.guest.Meaning;
import arcomat.guest.Vicinity;
import arcomat.guest.Vicinity.Kind;
import arcomat.guest.Vicinity.Value;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** ARC0334: the columns of a table are ports of the right direction, each once. */
final class Columns {
    static final String CODE = "ARC0334";

    private final Written table;
    private final Vicinity around;
    private final Map<String, Span> seen = new HashMap<>();

    Columns(Written table, Vicinity around) {
        this.table = table;
        this.around = around;
    }

    /**
     * Those of one side.
     *
     * @param meaning takes what is wrong with them
     */
    List<Column> of(List<Part> names, Kind side, Meaning meaning) {
        List<Column> columns = new ArrayList<>();
        for (Part name : names) {
            Span place = table.part(name.start(), name.end());
            columns.add(new Column(place, isPort(name.text(), place, side, meaning)));
        }
        return columns;
    }

    private boolean isPort(String name, Span place, Kind side, Meaning meaning) {
        Optional<Value> port = around.value(name).filter(Columns::isPort);
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
