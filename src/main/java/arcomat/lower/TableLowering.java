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
import java.util.Objects;
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
                List.of(List.of()),
                table.node().span());
    }

    private Optional<String> stereotype(String name) {
        return Stereotype.find(table.node().stereotypes(), name)
                .flatMap(Stereotype::value)
                .map(Name::text);
    }

    private List<Automaton.Transition> transitions() {
        List<Automaton.Transition> transitions = new ArrayList<>();
        List<List<InputCondition>> earlier = new ArrayList<>();
        for (TableSymbol.Row row : table.rows()) {
            List<InputCondition> conditions = conditions(row);
            transitions.add(transition(row, conditions, earlier));
            earlier.add(conditions);
        }
        return transitions;
    }

    private List<InputCondition> conditions(TableSymbol.Row row) {
        List<InputCondition> conditions = new ArrayList<>();
        List<TableSymbol.Column> columns = table.inputs();
        for (int i = 0; i < columns.size(); i++) {
            values.condition(port(columns.get(i)), row.inputs().get(i)).ifPresent(conditions::add);
        }
        return conditions;
    }

    private Automaton.Transition transition(
            TableSymbol.Row row,
            List<InputCondition> conditions,
            List<List<InputCondition>> earlier) {
        List<Automaton.Match> matches = new ArrayList<>();
        List<Expression> guards = new ArrayList<>();
        for (InputCondition condition : conditions) {
            condition.match().ifPresentOrElse(matches::add, () -> guards.add(condition.guard()));
        }
        for (List<InputCondition> other : earlier) {
            if (canMeet(conditions, other)) {
                guards.add(denial(other, row));
            }
        }
        return new Automaton.Transition(
                0,
                0,
                guards.isEmpty() ? Optional.empty() : Optional.of(Connectives.conjunction(guards)),
                matches,
                sends(row),
                List.of(),
                row.node().span());
    }

    private static boolean canMeet(List<InputCondition> row, List<InputCondition> other) {
        return row.stream().noneMatch(c -> other.stream().anyMatch(c::excludes));
    }

    /** A row without conditions matches always, so that nothing behind it ever does. */
    private static Expression denial(List<InputCondition> row, TableSymbol.Row place) {
        if (row.isEmpty()) {
            return new Expression.Constant(
                    new Value.BooleanValue(false), new Type.BooleanType(), place.node().span());
        }
        return Connectives.not(
                Connectives.conjunction(row.stream().map(InputCondition::guard).toList()));
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
        return Objects.requireNonNull(environment.ports().get(symbol.name()));
    }
}
