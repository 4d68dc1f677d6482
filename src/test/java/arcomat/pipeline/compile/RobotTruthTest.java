package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.AutomatonLines;
import arcomat.generate.CodeLayout;
import arcomat.generate.plan.Choosing;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.pipeline.brick.CoffeeRobot;
import arcomat.pipeline.brick.ForwardingObserver;
import arcomat.pipeline.generate.ProgramParts;
import arcomat.sim.Laboratory;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.device.LineNotes;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.SilentObserver;
import arcomat.sim.device.Stimulus;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.NotedLines;
import arcomat.sim.script.Action;
import arcomat.sim.script.Script;
import arcomat.sim.script.ScriptParser;
import arcomat.sim.script.Step;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * For the same sensor values, the logic does the same in every slice: interpreted, compiled for the
 * JVM, and in the jar on a simulated brick. On the brick, every port of every component is looked
 * at between two cycles, when the program sleeps. The transitions that were taken are those that
 * probes at lines of its code have seen.
 */
class RobotTruthTest {
    private static final int WORDS = 20;
    private static final int SLICES = 100;
    private static final int CYCLE = 100;

    @TestFactory
    Stream<DynamicTest> agreeOverTheirScripts() {
        return CoffeeRobot.NAMES.stream()
                .map(name -> DynamicTest.dynamicTest(name, () -> agree(name, script(name))));
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> agreeOverRandomRuns() {
        return CoffeeRobot.NAMES.stream()
                .map(name -> DynamicTest.dynamicTest(name, () -> agreeOverRandomRuns(name)));
    }

    private static void agreeOverRandomRuns(String name) {
        for (int seed = 0; seed < WORDS; seed++) {
            agree(name, random(new Random(seed)));
        }
    }

    private static Script script(String name) throws Exception {
        String simple = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        Path file = Path.of("models/coffee/scripts", simple + ".script");
        return ScriptParser.parse(Files.readString(file)).script().orElseThrow();
    }

    /** Values that stay for a while, near the thresholds of the models and far from them. */
    private static Script random(Random random) {
        List<Step> steps = new ArrayList<>();
        for (int slice = 0; slice < SLICES; slice++) {
            for (SensorName socket : SensorName.values()) {
                if (slice == 0 || random.nextInt(4) == 0) {
                    int value = random.nextBoolean() ? random.nextInt(2) : random.nextInt(100);
                    long time = (long) slice * CYCLE;
                    steps.add(new Step(time, new Action.Expose(socket, Stimulus.value(value))));
                }
            }
        }
        steps.add(new Step((long) SLICES * CYCLE, new Action.End()));
        return new Script(steps);
    }

    private static void agree(String name, Script script) {
        CoffeeRobot robot = CoffeeRobot.open(name);
        Seen seen = onBrick(robot, script);
        List<Map<String, Value>> onBrick = seen.slices();
        assertThat(onBrick).hasSizeGreaterThanOrEqualTo(40);

        CompiledModel compiled = CompiledModel.of(robot.component(), Choosing.FIRST);
        List<Letter> letters = onBrick.stream().map(slice -> sensed(robot, slice)).toList();
        assertThat(onBrick).isEqualTo(onJvm(compiled, letters));

        Interpreter interpreter = new Interpreter(robot.component(), List.of(), Choice.first());
        Trace interpreted = Simulation.run(interpreter, letters);
        assertThat(seen.taken()).isEqualTo(taken(interpreted)).isNotEmpty();
        Trace ran = Simulation.run(new CompiledExecution(compiled, List.of(), 0), letters);
        assertThat(ran).isEqualTo(interpreted);
        for (int slice = 0; slice < letters.size(); slice++) {
            assertThat(acted(robot, onBrick.get(slice)))
                    .as("%s, slice %d", name, slice)
                    .isEqualTo(interpreted.steps().get(slice).outputs());
        }
    }

    /**
     * What is seen of a run on a brick.
     *
     * @param slices every port of every component with its message, slice by slice
     * @param taken transitions that were taken, by the paths of parts and their places there
     */
    private record Seen(List<Map<String, Value>> slices, Set<String> taken) {}

    private static Set<String> taken(Trace trace) {
        Set<String> taken = new TreeSet<>();
        for (Trace.Step step : trace.steps()) {
            for (Trace.Activity each : step.activities()) {
                if (each.cause() instanceof Trace.Taken transition) {
                    taken.add(each.instance() + " " + transition.index());
                }
            }
        }
        return taken;
    }

    private static Seen onBrick(CoffeeRobot robot, Script script) {
        List<NotedLines> noted = new ArrayList<>();
        for (AutomatonLines each : robot.generation().layout().automata()) {
            List<Integer> lines = new ArrayList<>();
            for (int i = 0; i < each.automaton().transitions().size(); i++) {
                lines.add(each.lines().transitions().getOrDefault(i, 0));
            }
            noted.add(new NotedLines(each.className(), lines));
        }
        noted.add(new NotedLines(place(robot).className(), List.of()));
        Set<String> taken = new TreeSet<>();
        List<Map<String, Value>> slices = new ArrayList<>();
        try (Laboratory laboratory = new Laboratory()) {
            LoadedProgram program =
                    LoadedProgram.forMany(robot.program(), List.of(), noted).onThreads();
            SimulatedBrick brick = laboratory.place("robot", program);
            brick.observe(new Looker(robot, slices));
            brick.play(script);
            laboratory.runToEnd(60_000);
            assertThat(brick.outcome().failure()).isEmpty();
            ProgramParts.of(robot.component())
                    .keySet()
                    .forEach(path -> taken.addAll(taken(robot, path, brick.notes())));
        }
        return new Seen(slices, taken);
    }

    private static CodeLayout.Place place(CoffeeRobot robot) {
        return robot.generation().layout().components().get(robot.component().qualifiedName());
    }

    /** What the object has noted to which fields lead from that of the whole. */
    private static Set<String> taken(CoffeeRobot robot, String path, List<LineNotes> notes) {
        Object object =
                notes.stream()
                        .map(LineNotes::object)
                        .filter(each -> each.getClass().getName().equals(place(robot).className()))
                        .findFirst()
                        .orElseThrow();
        if (!path.isEmpty()) {
            CodeLayout layout = robot.generation().layout();
            object = Slot.follow(object, ProgramParts.fields(robot.component(), path, layout));
        }
        Set<String> taken = new TreeSet<>();
        for (LineNotes each : notes) {
            if (each.object() == object) {
                each.numbers().stream().forEach(number -> taken.add(path + " " + number));
            }
        }
        return taken;
    }

    /** Looks at the components whenever the program sleeps. */
    private static final class Looker extends ForwardingObserver {
        private final CoffeeRobot robot;
        private final List<Map<String, Value>> slices;

        Looker(CoffeeRobot robot, List<Map<String, Value>> slices) {
            super(new SilentObserver());
            this.robot = robot;
            this.slices = slices;
        }

        @Override
        public void slept(long from, long until) {
            Class<?> main =
                    StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE)
                            .walk(frames -> frames.map(f -> f.getDeclaringClass()).toList())
                            .stream()
                            .filter(c -> c.getName().equals(robot.programClass()))
                            .findFirst()
                            .orElseThrow();
            CompiledModel model =
                    new CompiledModel(
                            robot.component(),
                            Choosing.FIRST,
                            robot.generation().layout(),
                            main.getClassLoader());
            try {
                slices.add(ports(model, main.getField("whole").get(null)));
            } catch (ReflectiveOperationException e) {
                throw new AssertionError(e);
            }
        }
    }

    private static List<Map<String, Value>> onJvm(CompiledModel model, List<Letter> letters) {
        List<Map<String, Value>> slices = new ArrayList<>();
        Object whole = model.instantiate(model.place(model.component()).className(), List.of());
        Map<String, CodeParts.Part> parts = model.parts(whole);
        for (Letter letter : letters) {
            parts.forEach(
                    (path, part) -> {
                        if (part.component().platform()) {
                            part.component()
                                    .outputs()
                                    .forEach(p -> slot(model, path, part, p).write(letter));
                        }
                    });
            new Call(whole, "sense", 0).run();
            new Call(whole, "step", 0).run();
            slices.add(ports(model, whole));
        }
        return slices;
    }

    private static Map<String, Value> ports(CompiledModel model, Object whole) {
        Map<String, Value> ports = new LinkedHashMap<>();
        model.parts(whole)
                .forEach(
                        (path, part) -> {
                            for (Port port : part.component().ports()) {
                                PortSlot slot = slot(model, path, part, port);
                                slot.read().ifPresent(value -> ports.put(slot.name(), value));
                            }
                        });
        return ports;
    }

    private static PortSlot slot(CompiledModel model, String path, CodeParts.Part part, Port port) {
        return new PortSlot(
                path.isEmpty() ? port.name() : path + "." + port.name(),
                port,
                part.object(),
                model.place(part.component()),
                new JavaValues(model));
    }

    private static Letter sensed(CoffeeRobot robot, Map<String, Value> slice) {
        return ofDevices(robot, slice, false);
    }

    private static Letter acted(CoffeeRobot robot, Map<String, Value> slice) {
        return ofDevices(robot, slice, true);
    }

    private static Letter ofDevices(CoffeeRobot robot, Map<String, Value> slice, boolean inputs) {
        Map<String, Value> messages = new LinkedHashMap<>();
        Component.Composite body = (Component.Composite) robot.component().body();
        for (Component.Part part : body.parts()) {
            Component device = part.component();
            if (device.platform()) {
                for (Port port : inputs ? device.inputs() : device.outputs()) {
                    Value value = slice.get(part.name() + "." + port.name());
                    if (value != null) {
                        messages.put(part.name() + "." + port.name(), value);
                    }
                }
            }
        }
        return Letter.of(messages);
    }
}
