package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * An I/O table as an automaton with one state. The first row that matches decides: the guard of a
 * row denies the earlier rows, save those that can never match together with it.
 */
final class TableLowering {
    private static final String STATE = "table";

    private final TableSymbol table;
    private final Environment environment;
    private final ValueLowering values;

    TableLowering(TableSymbol table, Environment environment) {
        this.table = table;
        this.environment = environment;
        this.values = new ValueLowering(new ExpressionLowering(environment));
    }

    Automaton lower() {
        return new Automaton(
                "",
                Stereotypes.completion(stereotype("completion")),
                Stereotypes.omitted(stereotype("omitted")),
                Stereotypes.violated(stereotype("violated")),
                List.of(STATE),
                List.of(),
                List.of(new Automaton.Initial(0, List.of(), List.of(), table.node().span())),
                transitions(),
                List.of(table.node().span()),
                table.node().span());
    }

    private Optional<String> stereotype(String name) {
        return Stereotype.find(table.node().stereotypes(), name)
                .flatMap(Stereotype::value)
                .map(Name::text);
    }

    private List<Automaton.Transition> transitions() {
        List<Automaton.Transition> transitions = new ArrayList<>();
        List<List<PortCondition>> earlier = new ArrayList<>();
        for (TableSymbol.Row row : table.rows()) {
            List<PortCondition> conditions = conditions(row);
            transitions.add(transition(row, conditions, earlier));
            earlier.add(conditions);
        }
        return transitions;
    }

    private List<PortCondition> conditions(TableSymbol.Row row) {
        List<PortCondition> conditions = new ArrayList<>();
        List<TableSymbol.Column> columns = table.inputs();
        for (int i = 0; i < columns.size(); i++) {
            values.condition(port(columns.get(i)), row.inputs().get(i)).ifPresent(conditions::add);
        }
        return conditions;
    }

    private Automaton.Transition transition(
            TableSymbol.Row row,
            List<PortCondition> conditions,
            List<List<PortCondition>> earlier) {
        List<Automaton.Match> matches = new ArrayList<>();
        List<Expression> guards = new ArrayList<>();
        for (PortCondition condition : conditions) {
            condition.match().ifPresentOrElse(matches::add, () -> guards.add(condition.guard()));
        }
        for (List<PortCondition> other : earlier) {
            if (canMeet(conditions, other)) {
                guards.add(denial(other, row));
            }
        }
        return new Automaton.Transition(
                0,
                0,
                guards.isEmpty() ? Optional.empty() : Optional.of(Guards.conjunction(guards)),
                matches,
                sends(row),
                List.of(),
                row.node().span());
    }

    private static boolean canMeet(List<PortCondition> row, List<PortCondition> other) {
        return row.stream().noneMatch(c -> other.stream().anyMatch(c::excludes));
    }

    /** A row without conditions matches always, so that nothing behind it ever does. */
    private static Expression denial(List<PortCondition> row, TableSymbol.Row place) {
        if (row.isEmpty()) {
            return new Expression.Constant(
                    new Value.BooleanValue(false), new Type.BooleanType(), place.node().span());
        }
        return Guards.not(Guards.conjunction(row.stream().map(PortCondition::guard).toList()));
    }

    private List<Automaton.Send> sends(TableSymbol.Row row) {
        List<Automaton.Send> sends = new ArrayList<>();
        List<TableSymbol.Column> columns = table.outputs();
        for (int i = 0; i < columns.size(); i++) {
            ItemValue cell = row.outputs().get(i);
            values.send(port(columns.get(i)), cell).ifPresent(sends::add);
        }
        return sends;
    }

    private Port port(TableSymbol.Column column) {
        PortSymbol symbol = column.port().orElseThrow();
        return environment.ports().get(symbol.name());
    }
}
