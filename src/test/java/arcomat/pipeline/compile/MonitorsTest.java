package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.Choosing;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Monitors;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.lower.Lowering;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.Network;
import arcomat.simulate.Choice;
import arcomat.simulate.Interpreter;
import arcomat.simulate.RandomAutomata;
import arcomat.simulate.Simulation;
import arcomat.simulate.StreamTestResult;
import arcomat.simulate.StreamTests;
import arcomat.simulate.Watch;
import arcomat.symbols.Scenario;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Generated monitors, watches and stream tests say the same about a run: kept, or violated in that
 * slice. Runs of the component itself keep what it requires.
 */
class MonitorsTest {
    private static final int SLICES = 14;
    private static final Pattern SLICE = Pattern.compile("slice (\\d+): ");

    @Provide
    Arbitrary<Component> components() {
        return RandomAutomata.components();
    }

    @Property(seed = "1", tries = 60, edgeCases = EdgeCasesMode.NONE)
    void allAgreeOnRandomAutomata(@ForAll("components") Component component, @ForAll int seed) {
        agree(component, List.of(), seed, 12);
    }

    @TestFactory
    Stream<DynamicTest> allAgreeOnModels() {
        return watchable()
                .map(
                        component ->
                                DynamicTest.dynamicTest(
                                        component.qualifiedName(),
                                        () -> agree(component, arguments(component), 1, 40)));
    }

    /** Code and monitors are put into one program: what both bring is the same. */
    @TestFactory
    Stream<DynamicTest> monitorsFitTheCodeThatTheyWatch() {
        Target target = Target.shipped("jvm").orElseThrow();
        return watchable()
                .filter(component -> component.automata().size() == 1 && !component.isComposite())
                .map(
                        component ->
                                DynamicTest.dynamicTest(
                                        component.qualifiedName(),
                                        () -> {
                                            Map<String, String> code =
                                                    texts(
                                                            Generator.generate(
                                                                    Request.library(
                                                                            component,
                                                                            Choosing.FIRST),
                                                                    target));
                                            Map<String, String> monitors =
                                                    texts(
                                                            Monitors.generate(
                                                                    component,
                                                                    component.automata(),
                                                                    target));
                                            monitors.keySet().retainAll(code.keySet());
                                            assertThat(code).containsAllEntriesOf(monitors);
                                        }));
    }

    private static Map<String, String> texts(Generation generation) {
        return generation.files().stream()
                .collect(Collectors.toMap(GeneratedFile::path, GeneratedFile::text));
    }

    private static Stream<Component> watchable() {
        return Stream.concat(
                        Stream.of(
                                        "agreement/expressions.txt",
                                        "agreement/names.txt",
                                        "agreement/composition.txt",
                                        "agreement/networks.txt",
                                        "monitors/requirements.txt")
                                .map(file -> Path.of("src/test/resources", file))
                                .map(file -> Scenario.read(file).workspace()),
                        Stream.of(Scenario.models("models/coffee")))
                .flatMap(workspace -> Lowering.lower(workspace).components().stream())
                .filter(c -> c.profile() == Component.Profile.TIME_SYNCHRONOUS && !c.platform())
                .filter(component -> !component.automata().isEmpty());
    }

    private static List<Value> arguments(Component component) {
        Random random = new Random(component.parameters().size());
        return component.parameters().stream()
                .map(parameter -> Agreement.value(parameter.type(), random))
                .toList();
    }

    private static void agree(Component component, List<Value> arguments, int seed, int words) {
        CompiledMonitor monitor = CompiledMonitor.of(component);
        Random random = new Random(seed);
        for (int word = 0; word < words; word++) {
            List<Letter> run = run(component, arguments, random.nextInt());
            if (!component.isComposite()) {
                assertThat(monitor.watch(arguments, run)).allMatch(String::isEmpty);
            }
            List<Letter> damaged = damaged(run, component, random);
            String said = last(monitor.watch(arguments, damaged));
            assertThat(readable(said, component))
                    .isEqualTo(readable(watched(component, arguments, damaged), component));
            int slice = slice(said).orElse(-1);
            if (!component.isComposite()) {
                assertThat(slice).isEqualTo(judged(component, arguments, damaged));
            }
        }
    }

    /** Objects have no text of the model at run time. */
    private static String readable(String said, Component component) {
        boolean objects =
                component.outputs().stream().anyMatch(p -> p.type() instanceof Type.ClassType);
        return objects ? said.replaceAll(" forbids .*", "") : said;
    }

    /** What the ports show, inputs and outputs together. */
    private static List<Letter> run(Component component, List<Value> arguments, int seed) {
        Network network = Network.of(component, arguments);
        Interpreter interpreter =
                new Interpreter(component, arguments, Choice.randomThroughout(seed));
        List<Letter> letters = Simulation.randomLetters(network, seed, SLICES, 60);
        return Simulation.run(interpreter, letters).steps().stream()
                .map(
                        step -> {
                            Map<String, List<Value>> both =
                                    new LinkedHashMap<>(step.inputs().messages());
                            both.putAll(step.outputs().messages());
                            return new Letter(both);
                        })
                .toList();
    }

    /** Some messages are lost or replaced. */
    private static List<Letter> damaged(List<Letter> run, Component component, Random random) {
        List<Letter> damaged = new ArrayList<>();
        for (Letter slice : run) {
            Map<String, List<Value>> messages = new LinkedHashMap<>(slice.messages());
            for (Port port : component.outputs()) {
                if (random.nextInt(8) == 0) {
                    List<Value> other = List.of(Agreement.value(port.type(), random));
                    boolean silent = !port.total() && random.nextBoolean();
                    messages.put(port.name(), silent ? List.of() : other);
                }
            }
            damaged.add(new Letter(messages));
        }
        return damaged;
    }

    private static String last(List<String> said) {
        return said.isEmpty() ? "" : said.get(said.size() - 1);
    }

    private static Optional<Integer> slice(String said) {
        Matcher matcher = SLICE.matcher(said);
        return matcher.lookingAt()
                ? Optional.of(Integer.valueOf(matcher.group(1)))
                : Optional.empty();
    }

    /** What the watches say, in the first slice in which one says something. */
    private static String watched(Component component, List<Value> arguments, List<Letter> slices) {
        List<Watch> watches = new ArrayList<>();
        for (Automaton automaton : component.automata()) {
            watches.add(new Watch(component, automaton, arguments));
        }
        for (Letter slice : slices) {
            List<String> said =
                    watches.stream()
                            .flatMap(watch -> watch.see(slice, slice).stream())
                            .map(violation -> violation.message())
                            .collect(Collectors.toList());
            if (!said.isEmpty()) {
                return String.join("\n", said);
            }
        }
        return "";
    }

    /** The slice in which a stream test of the run fails, or -1. */
    private static int judged(Component component, List<Value> arguments, List<Letter> slices) {
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Port port : component.outputs()) {
            expected.put(port.name(), slices.stream().map(s -> s.messages(port.name())).toList());
        }
        List<Letter> inputs = slices.stream().map(slice -> inputs(slice, component)).toList();
        StreamTest test =
                new StreamTest("S", "t", component, arguments, inputs, expected, component.span());
        StreamTestResult result = StreamTests.run(test);
        if (result.failure().isPresent()) {
            return slice(result.failure().get()).orElseThrow();
        }
        return result.firstDifference().orElse(-1);
    }

    private static Letter inputs(Letter slice, Component component) {
        Map<String, List<Value>> messages = new LinkedHashMap<>();
        component.inputs().forEach(port -> messages.put(port.name(), slice.messages(port.name())));
        return new Letter(messages);
    }

    /** More than fit into one method, and more than have names of their own. */
    @Test
    void allAgreeOnManyStates() {
        int count = 300;
        String[] states = IntStream.range(0, count).mapToObj(i -> "s" + i).toArray(String[]::new);
        ComponentBuilder.AutomatonBuilder automaton =
                ComponentBuilder.component("Long")
                        .in(ComponentBuilder.BOOLEAN, "a")
                        .out(ComponentBuilder.MOTOR, "y")
                        .automaton(Automaton.Completion.IGNORE, states)
                        .initial("s0", "y = stop");
        for (int i = 0; i < count; i++) {
            String move = "s" + i + " -> s";
            automaton.on(move + (i + 1) % count, "a = true", "y = fwd");
            automaton.on(move + i * 7 % count, "a = false", "y = stop");
            automaton.on(move + i * 3 % count, "a = false", "y = ?");
        }
        agree(automaton.build(), List.of(), 3, 12);
    }

    @TestFactory
    Stream<DynamicTest> violationsAreFound() {
        return Stream.of("coffee.fig3.AvoidCrash", "coffee.fig6.AvoidCrash", "coffee.parts.Timer")
                .map(name -> DynamicTest.dynamicTest(name, () -> findsSome(name)));
    }

    /** Damage that matters is not rare. */
    private static void findsSome(String name) throws ModelError {
        Component component =
                Lowering.lower(Scenario.models("models/coffee")).component(name).orElseThrow();
        List<Value> arguments =
                component.parameters().isEmpty() ? List.of() : List.of(new Value.IntegerValue(3));
        CompiledMonitor monitor = CompiledMonitor.of(component);
        Random random = new Random(5);
        int found = 0;
        for (int word = 0; word < 20; word++) {
            List<Letter> run = run(component, arguments, random.nextInt());
            found +=
                    last(monitor.watch(arguments, damaged(run, component, random))).isEmpty()
                            ? 0
                            : 1;
        }
        assertThat(found).isBetween(2, 20);
    }
}
