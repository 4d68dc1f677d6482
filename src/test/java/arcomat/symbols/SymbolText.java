package arcomat.symbols;

import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.Delays.DelayCycle;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.UnitScope;
import arcomat.tree.Unit;
import arcomat.tree.Unit.Import;

import java.util.List;
import java.util.stream.Collectors;

/** Writes down what was resolved, and what was not. */
final class SymbolText {
    private final StringBuilder text = new StringBuilder();

    private SymbolText() {}

    static String of(Workspace workspace) {
        SymbolText text = new SymbolText();
        workspace.units().forEach(unit -> text.imports(workspace.scope(unit), unit));
        workspace.components().forEach(component -> text.component(workspace, component));
        workspace.bareAutomata().forEach(text::automaton);
        workspace.testSuites().forEach(text::suite);
        for (List<ComponentSymbol> cycle : workspace.subcomponentCycles()) {
            text.line(0, "contains itself: " + cycle);
        }
        return text.text.toString();
    }

    private void line(int depth, String content) {
        text.append("  ".repeat(depth)).append(content).append('\n');
    }

    private static String outcome(Resolution<?> resolution) {
        if (resolution.isAmbiguous()) {
            return "ambiguous " + resolution.candidates();
        }
        return resolution.found().isPresent()
                ? resolution.found().get().toString()
                : resolution.isUnknown() ? "unknown" : "excused";
    }

    private void imports(UnitScope scope, Unit unit) {
        for (Import imported : unit.imports()) {
            line(0, imported.span().text() + " " + outcome(scope.target(imported)));
        }
    }

    private void component(Workspace workspace, ComponentSymbol component) {
        line(
                0,
                "component "
                        + component
                        + (component.signature().isItsOwnAncestor() ? " extends itself" : ""));
        component
                .signature()
                .superComponent()
                .ifPresent(s -> line(1, "extends " + s.name() + ": " + outcome(s.resolution())));
        component
                .signature()
                .refines()
                .forEach(r -> line(1, "refines " + r.node() + ": " + outcome(r.resolution())));
        component
                .parameters()
                .forEach(
                        p ->
                                line(
                                        1,
                                        "parameter "
                                                + p.name()
                                                + ": "
                                                + outcome(p.typeResolution())
                                                + p.initial().map(SymbolText::typed).orElse("")));
        component.ports().forEach(this::port);
        component.instances().forEach(this::instance);
        component.connectors().forEach(this::connector);
        workspace
                .delays()
                .cycles(component)
                .forEach(c -> line(1, "cycle " + c.text() + " " + wires(c)));
        component.ownAutomata().forEach(this::automaton);
    }

    private static String wires(DelayCycle cycle) {
        return cycle.connectors().stream()
                .map(c -> c.source().key() + "->" + c.target().key())
                .collect(Collectors.joining(", ", "(", ")"));
    }

    private void port(PortSymbol port) {
        line(
                1,
                (port.isInput() ? "in " : "out ")
                        + port.name()
                        + ": "
                        + outcome(port.typeResolution())
                        + (port.implicit() ? " implicit" : ""));
    }

    private void instance(InstanceSymbol instance) {
        line(
                1,
                instance.origin().toString().toLowerCase()
                        + " "
                        + instance.name()
                        + ": "
                        + outcome(instance.type().resolution())
                        + instance.type().argumentTypes()
                        + instance.ports().stream()
                                .map(p -> " " + p.name() + ":" + p.type())
                                .collect(Collectors.joining()));
        instance.arguments().forEach(a -> line(2, "argument" + typed(a.value())));
    }

    private void connector(ConnectorSymbol connector) {
        line(
                1,
                connector.origin().toString().toLowerCase()
                        + " "
                        + end(connector.source())
                        + " -> "
                        + end(connector.target()));
    }

    private static String end(ConnectorSymbol.End end) {
        return end.isResolved()
                ? end.key() + (end.isSender() ? "!" : "?")
                : end.text() + " " + end.status();
    }

    private void automaton(AutomatonSymbol automaton) {
        line(1, "automaton " + automaton.name());
        automaton
                .variables()
                .forEach(
                        v ->
                                line(
                                        2,
                                        "variable "
                                                + v.name()
                                                + ": "
                                                + outcome(v.typeResolution())
                                                + v.initial().map(SymbolText::typed).orElse("")));
        for (TransitionSymbol transition : automaton.transitions()) {
            line(
                    2,
                    transition.source().map(StateSymbol::name).orElse("unknown")
                            + " -> "
                            + transition.target().map(StateSymbol::name).orElse("unknown"));
            transition.guard().ifPresent(g -> line(3, "guard" + typed(g)));
            transition.input().forEach(i -> line(3, item(i)));
            transition.output().forEach(i -> line(3, item(i)));
        }
    }

    private static String item(ItemSymbol item) {
        return item.side().toString().toLowerCase()
                + " "
                + outcome(item.target())
                + item.value().expressions().stream()
                        .map(SymbolText::typed)
                        .collect(Collectors.joining());
    }

    private static String typed(Typed typed) {
        String problems =
                typed.problems().stream()
                        .map(p -> " " + p.kind() + " at '" + p.span().text() + "': " + p.message())
                        .collect(Collectors.joining());
        return " '" + typed.expression().node().span().text() + "': " + typed.type() + problems;
    }

    private void suite(TestSuiteSymbol suite) {
        line(0, "suite " + suite.name() + " for " + outcome(suite.component()));
        for (StreamTestSymbol test : suite.tests()) {
            line(1, "test " + test.name() + " extent " + test.extent());
            for (StreamTestSymbol.StreamSymbol stream : test.streams()) {
                line(
                        2,
                        stream.kind().toString().toLowerCase()
                                + " "
                                + stream.node().port()
                                + ": "
                                + outcome(stream.port())
                                + (stream.isDriven() ? " driven" : "")
                                + stream.messages().stream()
                                        .map(SymbolText::typed)
                                        .collect(Collectors.joining()));
            }
        }
    }
}
