package arcomat.analysis.search.composition;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.SimulatedRuns;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.models.ReadModels;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTestResult.Verdict;
import arcomat.simulate.test.StreamTests;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;

/**
 * Stream tests of random event-driven compositions: what a run shows is allowed, and where nothing
 * is left open, everything else is judged as the simulator does with every sequence of choices.
 * More with {@code -Dmodels=10000}, others with {@code -Dfirst=7}.
 */
class AllowedEventsTest {
    private static final int MODELS = Integer.getInteger("models", 30);
    private static final int FIRST = Integer.getInteger("first", 0);
    private static final int EVENTS = 5;

    @Tag("slow")
    @Test
    void whatARunShowsIsAllowed() {
        for (int seed = FIRST; seed < FIRST + MODELS; seed++) {
            int number = seed;
            Component component = opened(seed);
            for (Choice choice :
                    List.of(
                            Choice.first(),
                            Choice.random(seed),
                            Choice.randomThroughout(seed),
                            Choice.randomThroughout(~seed))) {
                Trace trace = run(component, choice, seed);
                if (trace.steps().isEmpty()) {
                    continue;
                }
                StreamTest test = recorded(component, trace);
                assertThat(StreamTests.run(test).verdict())
                        .as(() -> text(number, test))
                        .isNotEqualTo(Verdict.FAILED);
            }
        }
    }

    @Test
    void everySequenceOfChoicesJudgesAlike() {
        for (int seed = FIRST; seed < FIRST + MODELS; seed++) {
            int number = seed;
            Component component = RandomCompositions.of(seed, false);
            Trace trace = run(component, Choice.random(seed), seed);
            StreamTest recorded = recorded(component, trace);
            Set<SimulatedRuns.Run> recordedRuns =
                    SimulatedRuns.of(component, List.of(), recorded.inputs());
            Random random = new Random(seed);
            StreamTest longer = longer(recorded, seed);
            Set<SimulatedRuns.Run> longerRuns =
                    SimulatedRuns.of(component, List.of(), longer.inputs());
            for (int i = 0; i < 6; i++) {
                boolean more = i % 2 == 0;
                Set<SimulatedRuns.Run> runs = more ? longerRuns : recordedRuns;
                StreamTest test = changed(more ? longer : recorded, random);
                assertThat(StreamTests.run(test).verdict())
                        .as(() -> text(number, test))
                        .isEqualTo(
                                runs.stream().anyMatch(run -> shows(run, test))
                                        ? Verdict.PASSED
                                        : Verdict.FAILED);
            }
        }
    }

    private static boolean shows(SimulatedRuns.Run run, StreamTest test) {
        if (run.error()) {
            return false;
        }
        return test.expected().entrySet().stream()
                .allMatch(
                        entry ->
                                run.outputs().stream()
                                        .flatMap(
                                                step ->
                                                        step
                                                                .getOrDefault(
                                                                        entry.getKey(), List.of())
                                                                .stream())
                                        .toList()
                                        .equals(entry.getValue().get(0)));
    }

    /** A random composition of which some parts leave open what they do not handle. */
    private static Component opened(long seed) {
        return Lowering.lower(ReadModels.workspace(files(seed)))
                .component("load.Whole")
                .orElseThrow();
    }

    private static List<SourceFile> files(long seed) {
        Random random = new Random(seed);
        String[] texts = RandomCompositions.text(seed, false).split("(?=package load;)");
        List<SourceFile> files = new ArrayList<>();
        for (int i = 0; i < texts.length; i++) {
            String name = i + 1 < texts.length ? "P" + i : "Whole";
            String completion = List.of("chaos", "output", "ignore").get(random.nextInt(3));
            String text = texts[i].replace("\"ignore\"", "\"" + completion + "\"");
            files.add(new SourceFile("load/" + name + ".arc", text));
        }
        return files;
    }

    private static Trace run(Component component, Choice choice, int seed) {
        Interpreter interpreter = new Interpreter(component, List.of(), choice);
        List<Letter> letters =
                Simulation.drawn(interpreter.network(), seed, 0).limit(EVENTS).toList();
        return Simulation.run(interpreter, letters);
    }

    /** What a trace shows, as {@code simulate --record} writes it. */
    private static StreamTest recorded(Component component, Trace trace) {
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Network.External output : Network.of(component, List.of()).outputs()) {
            List<Value> messages = new ArrayList<>();
            trace.steps().forEach(each -> messages.addAll(each.outputs().messages(output.name())));
            expected.put(output.name(), List.of(messages));
        }
        List<Letter> inputs = trace.steps().stream().map(Trace.Step::inputs).toList();
        return test(component, inputs, expected);
    }

    private static StreamTest test(
            Component component, List<Letter> inputs, Map<String, List<List<Value>>> expected) {
        return new StreamTest(
                "Suite", "test", component, List.of(), inputs, expected, ComponentBuilder.NOWHERE);
    }

    /** With an event more, after which the component may have ended in an error. */
    private static StreamTest longer(StreamTest test, int seed) {
        Network network = Network.of(test.component(), List.of());
        List<Letter> inputs = new ArrayList<>(test.inputs());
        inputs.addAll(Simulation.drawn(network, ~seed, 0).limit(1).toList());
        return test(test.component(), inputs, test.expected());
    }

    private static StreamTest changed(StreamTest test, Random random) {
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>(test.expected());
        for (String port : List.copyOf(expected.keySet())) {
            List<Value> messages = new ArrayList<>(expected.get(port).get(0));
            switch (random.nextInt(5)) {
                case 0 -> expected.remove(port);
                case 1 -> messages.add(new Value.IntegerValue(random.nextInt(3)));
                case 2 -> {
                    if (!messages.isEmpty()) {
                        messages.remove(random.nextInt(messages.size()));
                    }
                }
                default -> {}
            }
            expected.computeIfPresent(port, (key, old) -> List.of(messages));
        }
        return test(test.component(), test.inputs(), expected);
    }

    private static String text(long seed, StreamTest test) {
        StringBuilder text = new StringBuilder("seed " + seed + "\n");
        files(seed).forEach(file -> text.append(file.text()));
        return text.append(test.inputs()).append('\n').append(test.expected()).toString();
    }
}
