package arcomat.simulate;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.MOTOR;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTestResult.Verdict;
import arcomat.simulate.test.StreamTests;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** Laws that hold for every automaton. */
class MeaningProperties {
    private static final int SLICES = 12;

    @Provide
    Arbitrary<RandomAutomata.Recipe> recipes() {
        return RandomAutomata.recipes();
    }

    @Provide
    Arbitrary<Component> components() {
        return RandomAutomata.components();
    }

    @Provide
    Arbitrary<List<Component>> parts() {
        return RandomAutomata.components().list().ofMinSize(2).ofMaxSize(5);
    }

    @Provide
    Arbitrary<Integer> seeds() {
        return Arbitraries.integers();
    }

    private static Trace run(Component component, Choice choice, int seed) {
        Interpreter interpreter = new Interpreter(component, List.of(), choice);
        return Simulation.run(
                interpreter,
                Simulation.drawn(interpreter.network(), seed, 60).limit(SLICES).toList());
    }

    /** What a trace shows, as a test of a component with the same ports. */
    private static StreamTest test(Component component, Trace trace) {
        List<Letter> inputs = new ArrayList<>();
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        component.outputs().forEach(port -> expected.put(port.name(), new ArrayList<>()));
        for (Trace.Step step : trace.steps()) {
            inputs.add(step.inputs());
            for (Port port : component.outputs()) {
                expected.get(port.name()).add(step.outputs().messages(port.name()));
            }
        }
        return new StreamTest(
                "Suite", "test", component, List.of(), inputs, expected, ComponentBuilder.NOWHERE);
    }

    private static Verdict verdict(Component component, Trace trace) {
        return StreamTests.run(test(component, trace)).verdict();
    }

    @Property(seed = "1", tries = 200, edgeCases = EdgeCasesMode.NONE)
    void theInterpreterDoesWhatTheRelationAllows(
            @ForAll("components") Component component, @ForAll("seeds") int seed) {
        for (Choice choice :
                List.of(Choice.first(), Choice.random(seed), Choice.randomThroughout(seed))) {
            assertThat(verdict(component, run(component, choice, seed)))
                    .isNotEqualTo(Verdict.FAILED);
        }
    }

    /** Ignore refines output, and output refines chaos. */
    @Property(seed = "2", tries = 200, edgeCases = EdgeCasesMode.NONE)
    void aStrongerCompletionHasFewerRuns(
            @ForAll("recipes") RandomAutomata.Recipe recipe,
            @ForAll boolean instant,
            @ForAll("seeds") int seed) {
        Component chaos = recipe.with(Completion.CHAOS, instant);
        Component output = recipe.with(Completion.OUTPUT, instant);
        Component ignore = recipe.with(Completion.IGNORE, instant);
        Trace ignoring = run(ignore, Choice.random(seed), seed);
        assertThat(verdict(output, ignoring)).isEqualTo(Verdict.PASSED);
        assertThat(verdict(chaos, ignoring)).isNotEqualTo(Verdict.FAILED);
        Trace sending = run(output, Choice.randomThroughout(seed), seed);
        assertThat(verdict(chaos, sending)).isNotEqualTo(Verdict.FAILED);
    }

    @Property(seed = "3", tries = 100, edgeCases = EdgeCasesMode.NONE)
    void aNetworkOfOnePartBehavesLikeThePart(
            @ForAll("components") Component part, @ForAll("seeds") int seed) {
        Component whole = network(List.of(part), List.of(0), false);
        Trace inside = run(whole, Choice.random(seed), seed);
        Trace alone = run(part, Choice.random(seed), seed);
        assertThat(outputs(inside)).isEqualTo(outputs(alone));
    }

    @Property(seed = "4", tries = 100, edgeCases = EdgeCasesMode.NONE)
    void theOrderOfDeclarationDoesNotMatter(
            @ForAll("parts") List<Component> parts, @ForAll("seeds") int seed) {
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < parts.size(); i++) {
            order.add(i);
        }
        Trace straight = run(network(parts, order, false), Choice.first(), seed);
        Collections.shuffle(order, new Random(seed));
        assertThat(outputs(run(network(parts, order, false), Choice.first(), seed)))
                .isEqualTo(outputs(straight));
        assertThat(outputs(run(network(parts, order, true), Choice.first(), seed)))
                .isEqualTo(outputs(straight));
    }

    private static List<Letter> outputs(Trace trace) {
        return trace.steps().stream().map(Trace.Step::outputs).toList();
    }

    /** A chain of the parts, declared in an order, each in a component of its own if asked for. */
    private static Component network(
            List<Component> parts, List<Integer> declared, boolean wrapped) {
        ComponentBuilder whole =
                ComponentBuilder.component("Whole")
                        .in(BOOLEAN, "a")
                        .in(MOTOR, "b")
                        .out(BOOLEAN, "x")
                        .out(MOTOR, "y");
        for (int k : declared) {
            Component part = parts.get(k);
            whole.part("p" + k, wrapped ? network(List.of(part), List.of(0), false) : part);
            String from = "p" + (k - 1) + ".";
            whole.connect(k == 0 ? "a" : from + "x", "p" + k + ".a");
            whole.connect(k == 0 ? "b" : from + "y", "p" + k + ".b");
        }
        String last = "p" + (parts.size() - 1) + ".";
        return whole.connect(last + "x", "x").connect(last + "y", "y").build();
    }

    @Property(seed = "5", tries = 50, edgeCases = EdgeCasesMode.NONE)
    void oneSeedIsOneRun(@ForAll("parts") List<Component> parts, @ForAll("seeds") int seed) {
        List<Integer> order = List.of(0, 1);
        Component whole = network(parts.subList(0, 2), order, false);
        assertThat(run(whole, Choice.random(seed), seed).steps())
                .isEqualTo(run(whole, Choice.random(seed), seed).steps());
        Network network = Network.of(whole, List.of());
        assertThat(Simulation.drawn(network, seed, 50).limit(SLICES).toList())
                .isEqualTo(Simulation.drawn(network, seed, 50).limit(SLICES).toList());
    }
}
