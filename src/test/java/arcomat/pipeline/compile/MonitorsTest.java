package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Monitors;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.pipeline.compile.CompiledMonitor.Word;
import arcomat.rt.ModelError;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.network.Network;
import arcomat.simulate.RandomAutomata;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;
import arcomat.simulate.watch.Watch;
import arcomat.simulate.watch.Watch.Violation;
import arcomat.simulate.watch.Watching;
import arcomat.simulate.watch.Watching.Watched;
import arcomat.symbols.Scenario;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

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

    @Tag("slow")
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

    /**
     * Where a transition goes wrong or leaves something open, too; what grows has grown by then.
     */
    @ParameterizedTest
    @ValueSource(strings = {"p.Lively", "p.Chatty"})
    void nothingIsAllocatedInASlice(String name) {
        Path file = Path.of("src/test/resources/monitors/lively.txt");
        Component component =
                Lowering.lower(Scenario.read(file).workspace()).component(name).orElseThrow();
        Trace run =
                IntStream.range(0, 20)
                        .mapToObj(seed -> run(component, List.of(), seed, 1000))
                        .filter(some -> some.steps().size() == 1000)
                        .findFirst()
                        .orElseThrow();
        CompiledMonitor monitor = CompiledMonitor.of(component);
        assertThat(monitor.allocated(List.of(), run, 0)).isPositive();
        assertThat(monitor.allocated(List.of(), run, 300)).isZero();
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
                                        "agreement/events.txt",
                                        "monitors/requirements.txt",
                                        "monitors/events.txt",
                                        "monitors/lively.txt")
                                .map(file -> Path.of("src/test/resources", file))
                                .map(file -> Scenario.read(file).workspace()),
                        Stream.of(Scenario.models("models/coffee")))
                .flatMap(workspace -> Lowering.lower(workspace).components().stream())
                .filter(component -> !component.platform())
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
            Trace run = run(component, arguments, random.nextInt());
            if (!component.isComposite() && !errsAfterChaos(run)) {
                assertThat(monitor.watch(arguments, run)).isEqualTo(new Word("", ""));
            }
            Trace damaged = damaged(run, component, random);
            Word said = monitor.watch(arguments, damaged);
            assertThat(readable(said.violation(), component))
                    .isEqualTo(readable(watched(component, arguments, damaged), component));
            assertThat(said.unknown()).isEmpty();
            boolean slices = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
            // where automata contradict each other to begin with, a test fails that sees nothing
            boolean seen = !damaged.steps().isEmpty() && damaged.end().isEmpty();
            if (slices && !component.isComposite() && seen) {
                int slice = slice(said.violation()).orElse(-1);
                assertThat(slice).isEqualTo(judged(component, arguments, damaged));
            }
        }
    }

    /**
     * A run stays where it is after chaos, and may go wrong there; chaos allows everything else.
     */
    private static boolean errsAfterChaos(Trace run) {
        Trace.Cause chaos = new Trace.Completed(Automaton.Completion.CHAOS);
        return run.end().isPresent()
                && run.steps().stream()
                        .flatMap(step -> step.activities().stream())
                        .anyMatch(activity -> activity.cause().equals(chaos));
    }

    /**
     * Objects have no text of the model at run time, floats one of their own; latched ports change
     * without an event.
     */
    private static String readable(String said, Component component) {
        boolean objects =
                component.outputs().stream()
                        .map(Port::type)
                        .anyMatch(
                                type ->
                                        type instanceof Type.ClassType
                                                || type instanceof Type.RealType real
                                                        && real.single());
        boolean latched = component.inputs().stream().anyMatch(Port::latched);
        String numbered = latched ? said.replaceAll("event \\d+", "event") : said;
        return objects ? numbered.replaceAll(" forbids .*", "") : numbered;
    }

    private static Trace run(Component component, List<Value> arguments, int seed) {
        return run(component, arguments, seed, SLICES);
    }

    private static Trace run(Component component, List<Value> arguments, int seed, int slices) {
        Network network = Network.of(component, arguments);
        Interpreter interpreter =
                new Interpreter(component, arguments, Choice.randomThroughout(seed));
        return Simulation.run(
                interpreter, Simulation.drawn(network, seed, 60).limit(slices).toList());
    }

    /**
     * Some messages are lost or replaced; now and then the run ends in an error, and may show more
     * than it should.
     */
    private static Trace damaged(Trace run, Component component, Random random) {
        List<Trace.Step> damaged = new ArrayList<>();
        for (Trace.Step step : run.steps()) {
            Letter opening = run.opening().filter(o -> step.number() == 0).orElse(Letter.SILENCE);
            Letter outputs =
                    happens(step, component)
                            ? damaged(step.outputs(), opening, component, random)
                            : step.outputs();
            damaged.add(new Trace.Step(step.number(), step.inputs(), outputs, List.of()));
        }
        if (run.end().isPresent() || damaged.isEmpty() || random.nextInt(4) > 0) {
            return new Trace(component, damaged, run.failure(), run.opening(), run.end());
        }
        Trace.Step last = damaged.get(random.nextInt(damaged.size()));
        if (!happens(last, component)) {
            return new Trace(component, damaged, run.failure(), run.opening(), run.end());
        }
        List<Trace.Step> kept = damaged.subList(0, last.number());
        Map<String, List<Value>> late = new LinkedHashMap<>(last.outputs().messages());
        boolean slices = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
        boolean tooMuch = random.nextBoolean();
        late.keySet()
                .removeIf(
                        name ->
                                !slices
                                        || !tooMuch
                                                && component.port(name).orElseThrow().delay() == 0);
        Trace.End end = new Trace.End(last.inputs(), new Letter(late));
        return new Trace(component, kept, Optional.of("damage"), run.opening(), Optional.of(end));
    }

    /** Generated monitors are not told of latched ports that change without an event. */
    private static boolean happens(Trace.Step step, Component component) {
        return component.profile() == Component.Profile.TIME_SYNCHRONOUS
                || component.inputs().stream()
                        .filter(port -> !port.latched())
                        .anyMatch(port -> !step.inputs().messages(port.name()).isEmpty());
    }

    private static Letter damaged(
            Letter shown, Letter opening, Component component, Random random) {
        Map<String, List<Value>> messages = new LinkedHashMap<>(shown.messages());
        for (Port port : component.outputs()) {
            if (random.nextInt(8) == 0) {
                List<Value> others = new ArrayList<>(opening.messages(port.name()));
                if (port.total() || random.nextBoolean()) {
                    others.add(Agreement.value(port.type(), random));
                }
                messages.put(port.name(), others);
            }
        }
        return new Letter(messages);
    }

    private static Optional<Integer> slice(String said) {
        Matcher matcher = SLICE.matcher(said);
        return matcher.lookingAt()
                ? Optional.of(Integer.valueOf(matcher.group(1)))
                : Optional.empty();
    }

    /** What the watches say, in the first slice in which one says something. */
    private static String watched(Component component, List<Value> arguments, Trace run) {
        List<Watch> watches = new ArrayList<>();
        for (Automaton automaton : component.automata()) {
            watches.add(new Watch(component, automaton, arguments));
        }
        List<Violation> found =
                Watching.all(watches, run).stream().flatMap(w -> w.violation().stream()).toList();
        int first = found.stream().mapToInt(Violation::slice).min().orElse(-1);
        return found.stream()
                .filter(violation -> violation.slice() == first)
                .map(Violation::message)
                .collect(Collectors.joining("\n"));
    }

    /** The slice in which a stream test of the run fails, or -1. */
    private static int judged(Component component, List<Value> arguments, Trace run) {
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Port port : component.outputs()) {
            expected.put(
                    port.name(),
                    run.steps().stream().map(s -> s.outputs().messages(port.name())).toList());
        }
        List<Letter> inputs = run.steps().stream().map(Trace.Step::inputs).toList();
        StreamTest test =
                new StreamTest("S", "t", component, arguments, inputs, expected, component.span());
        StreamTestResult result = StreamTests.run(test);
        if (result.failure().isPresent()) {
            return slice(result.failure().get()).orElseThrow();
        }
        return result.firstDifference().orElse(-1);
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

    /** The ways to go on double in every slice; what is open all along is followed all the same. */
    @Test
    void bothGiveUpWhereThereAreTooManyWays() {
        Component guess = component("p.Guess");
        Trace run = run(guess, List.of(), 1, 20);
        Word said = CompiledMonitor.of(guess).watch(List.of(), run);
        Watch watch = new Watch(guess, guess.automata().get(0), List.of());
        Watched watched = Watching.all(List.of(watch), run).get(0);
        assertThat(said.violation()).isEmpty();
        assertThat(said.unknown()).startsWith("more than 100000 ways to go on in slice 1");
        assertThat(watched.unknown()).hasValue(said.unknown());
    }

    @Test
    void afterChaosOnlyAnErrorIsUnknown() {
        Component component = component("p.GuessOrNothing");
        Trace run = run(component, List.of(), 1, 20);
        Trace.End end = new Trace.End(Letter.SILENCE, Letter.SILENCE);
        Trace ended =
                new Trace(
                        component,
                        run.steps(),
                        Optional.of("error"),
                        Optional.empty(),
                        Optional.of(end));
        for (Trace each : List.of(run, ended)) {
            Word said = CompiledMonitor.of(component).watch(List.of(), each);
            Watch watch = new Watch(component, component.automata().get(0), List.of());
            Watched watched = Watching.all(List.of(watch), each).get(0);
            assertThat(said.violation()).isEmpty();
            assertThat(watched.violation()).isEmpty();
            assertThat(watched.nothingFrom()).hasValue(1);
            assertThat(said.unknown().isEmpty()).isEqualTo(each.end().isEmpty());
            assertThat(watched.unknown().orElse("")).isEqualTo(said.unknown());
        }
    }

    private static Component component(String name) {
        Path file = Path.of("src/test/resources/monitors/many.txt");
        return Lowering.lower(Scenario.read(file).workspace()).component(name).orElseThrow();
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
            Trace damaged = damaged(run(component, arguments, random.nextInt()), component, random);
            found += monitor.watch(arguments, damaged).violation().isEmpty() ? 0 : 1;
        }
        assertThat(found).isBetween(2, 20);
    }
}
