package arcomat.symbols.bodies;

import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Block;
import arcomat.tree.IoTable;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** An I/O table with resolved columns and typed cells. */
public final class TableSymbol {
    /**
     * A column; {@code port} is empty where the component has no port of that name, whichever
     * direction.
     */
    public record Column(Name node, boolean input, Optional<PortSymbol> port) {
        /** The type of its messages; unknown where the port is. */
        public TypeSymbol type() {
            return port.<TypeSymbol>map(PortSymbol::type).orElse(UnknownType.UNKNOWN);
        }
    }

    /** A row; cells beyond the columns are typed without an expectation. */
    public record Row(IoTable.Row node, List<ItemValue> inputs, List<ItemValue> outputs) {
        public Row {
            inputs = List.copyOf(inputs);
            outputs = List.copyOf(outputs);
        }
    }

    private final IoTable node;
    private final ComponentSymbol component;
    private final Lazy<List<Row>> rows = new Lazy<>(this::makeRows);

    TableSymbol(IoTable node, ComponentSymbol component) {
        this.node = node;
        this.component = component;
    }

    public IoTable node() {
        return node;
    }

    public ComponentSymbol component() {
        return component;
    }

    public List<Column> inputs() {
        return columns(node.inputs(), true);
    }

    public List<Column> outputs() {
        return columns(node.outputs(), false);
    }

    public List<Row> rows() {
        return rows.get();
    }

    /** What cells may name: input ports, constants, parameters. */
    public ValueScope scope() {
        return component.constantScope().with(component.ports());
    }

    private List<Column> columns(List<Name> names, boolean input) {
        return names.stream()
                .map(name -> new Column(name, input, component.port(name.text())))
                .toList();
    }

    private List<Row> makeRows() {
        ValueScope scope = scope();
        List<Column> inputs = inputs();
        List<Column> outputs = outputs();
        return node.rows().stream()
                .map(
                        row ->
                                new Row(
                                        row,
                                        cells(row.inputs(), inputs, scope),
                                        cells(row.outputs(), outputs, scope)))
                .toList();
    }

    private static List<ItemValue> cells(
            List<Block.Value> cells, List<Column> columns, ValueScope scope) {
        List<ItemValue> typed = new ArrayList<>();
        for (int i = 0; i < cells.size(); i++) {
            TypeSymbol expected = i < columns.size() ? columns.get(i).type() : UnknownType.UNKNOWN;
            ItemValue value = ItemValue.of(cells.get(i), scope, expected);
            typed.add(expected.isErroneous() ? value.withoutUnknownNames() : value);
        }
        return typed;
    }
}
