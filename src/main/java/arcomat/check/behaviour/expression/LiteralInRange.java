package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.ConstantFolding;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.RangeType;
import arcomat.symbols.names.TypeSymbol;

import java.util.List;

/** ARC0322: a number that is sent, stored, waited for or passed on lies in the range there. */
public final class LiteralInRange
        implements Check.OnComponent,
                Check.OnInstance,
                Check.OnVariable,
                Check.OnItem,
                Check.OnTable,
                Check.OnTestSuite,
                Check.OnStreamTest {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (ParameterSymbol parameter : component.signature().ownParameters()) {
            parameter.initial().ifPresent(value -> check(value, parameter.type(), findings));
        }
    }

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        instance.component().ifPresent(c -> check(instance.arguments(), c, findings));
    }

    @Override
    public void check(VariableSymbol variable, Context context, Findings findings) {
        variable.initial().ifPresent(value -> check(value, variable.type(), findings));
    }

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        item.target().found().ifPresent(target -> checkAll(item.value(), target.type(), findings));
    }

    @Override
    public void check(TableSymbol table, Context context, Findings findings) {
        for (TableSymbol.Row row : table.rows()) {
            check(row.inputs(), table.inputs(), findings);
            check(row.outputs(), table.outputs(), findings);
        }
    }

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        suite.component().found().ifPresent(c -> check(suite.arguments(), c, findings));
    }

    @Override
    public void check(StreamTestSymbol test, Context context, Findings findings) {
        for (StreamTestSymbol.StreamSymbol stream : test.streams()) {
            stream.messages().forEach(message -> check(message, stream.type(), findings));
        }
    }

    private static void check(List<Typed> arguments, ComponentSymbol component, Findings findings) {
        List<ParameterSymbol> parameters = component.parameters();
        for (int i = 0; i < Math.min(arguments.size(), parameters.size()); i++) {
            check(arguments.get(i), parameters.get(i).type(), findings);
        }
    }

    private static void check(
            List<ItemValue> cells, List<TableSymbol.Column> columns, Findings findings) {
        for (int i = 0; i < Math.min(cells.size(), columns.size()); i++) {
            checkAll(cells.get(i), columns.get(i).type(), findings);
        }
    }

    private static void checkAll(ItemValue value, TypeSymbol type, Findings findings) {
        value.expressions().forEach(expression -> check(expression, type, findings));
    }

    /** A range that is reversed has a finding already. */
    private static void check(Typed typed, TypeSymbol type, Findings findings) {
        if (type instanceof RangeType range && range.low() <= range.high()) {
            ConstantFolding.computed(typed.expression())
                    .filter(number -> !range.contains(number))
                    .ifPresent(number -> report(typed, number, range, findings));
        }
    }

    private static void report(Typed typed, long number, RangeType range, Findings findings) {
        findings.report(
                typed.expression().node(),
                "%s lies outside of %s; write a number from %s to %s or widen the range",
                number,
                range.text(),
                range.low(),
                range.high());
    }
}
