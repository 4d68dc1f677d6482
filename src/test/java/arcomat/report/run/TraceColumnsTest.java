package arcomat.report.run;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.util.List;
import java.util.stream.Stream;

/** Columns are known before a run begins: nothing comes up for which there is none. */
class TraceColumnsTest {
    @TestFactory
    Stream<DynamicTest> allThatOccursHasAColumn() {
        return Lowering.lower(Scenario.models("models/coffee")).components().stream()
                .filter(component -> component.parameters().isEmpty())
                .map(
                        component ->
                                DynamicTest.dynamicTest(
                                        component.qualifiedName(), () -> hasColumns(component)));
    }

    private static void hasColumns(Component component) {
        Network network = Network.of(component, List.of());
        Interpreter interpreter = new Interpreter(component, List.of(), Choice.random(1));
        Trace run =
                Simulation.run(interpreter, Simulation.drawn(network, 1, 60).limit(50).toList());
        TraceColumns occurring = TraceColumns.of(run);
        TraceColumns all = TraceColumns.of(network);
        assertThat(all.inputs()).containsAll(occurring.inputs());
        assertThat(all.outputs()).containsAll(occurring.outputs());
        assertThat(all.automata()).containsAll(occurring.automata());
        assertThat(all.unit()).isEqualTo(occurring.unit());
    }
}
