package arcomat.pipeline.brick;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.inside.Refusing;
import arcomat.sim.Laboratory;
import arcomat.sim.Outcome;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.device.Limits;
import arcomat.sim.device.SensorName;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.script.Action;
import arcomat.sim.script.Script;
import arcomat.sim.script.Step;
import arcomat.sim.time.VirtualTime;
import arcomat.sim.trace.Lateness;
import arcomat.sim.trace.Recorder;
import arcomat.sim.trace.Recorder.Misfit;
import arcomat.sim.trace.Trace;
import arcomat.simulate.run.RobotRun;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * Runs a robot's jar on a simulated brick: the very classes that go on the brick.
 *
 * @param jar path of the jar
 * @param script path of a script that says what happens to the brick
 * @param devices what is plugged into sockets: kinds of devices, or paths of Java files
 * @param seconds of virtual time at most; empty for as long as the script says
 * @param patience of the PC's time at most
 * @param limits those of the brick that the program meets
 * @param models that the jar was made of, where somebody wants to know what went on inside
 */
public record RunJar(
        String jar,
        Optional<String> script,
        Map<SensorName, String> devices,
        OptionalInt seconds,
        Duration patience,
        Limits limits,
        Optional<JarModels> models)
        implements Task<RunJar.Result> {
    private static final long MILLISECONDS = 1000;

    /** How long a run goes on where nothing says, behind the script's last line. */
    private static final long USUAL = 10_000;

    /** Without devices and models, with the usual patience, and all limits. */
    public RunJar(String jar, Optional<String> script, OptionalInt seconds) {
        this(
                jar,
                script,
                Map.of(),
                seconds,
                Laboratory.PATIENCE,
                Limits.OF_THE_BRICK,
                Optional.empty());
    }

    /**
     * What came of it.
     *
     * @param findings about the program, the script, or the models
     * @param run empty exactly if the findings did not let the program run
     */
    public record Result(List<Diagnostic> findings, Optional<Run> run) {}

    /**
     * A run.
     *
     * @param milliseconds of virtual time
     * @param ending how it ended, in words: "the program ended"
     * @param failure what nothing in the program caught
     * @param misfits what the script exposes sensors to, and they cannot sense
     * @param lateness how often the program came late
     * @param screen what the display shows at the end, without empty rows at its end
     * @param inside what its model did, where models were given
     */
    public record Run(
            Trace trace,
            long milliseconds,
            String ending,
            Optional<String> failure,
            List<Misfit> misfits,
            Lateness lateness,
            List<String> screen,
            Optional<RobotRun> inside) {}

    /**
     * Runs the program, if nothing speaks against it.
     *
     * @throws WrongUse where jar or script cannot be read, or the jar was made of other models
     * @throws arcomat.sim.time.OutOfPatience where it takes longer than it may
     */
    @Override
    public Result run(Session session) throws WrongUse {
        JarReader program = JarReader.read(jar, session.names());
        List<Diagnostic> obstacles = program.report().obstacles();
        if (!obstacles.isEmpty()) {
            return new Result(obstacles, Optional.empty());
        }
        Script events = new Script(List.of());
        if (script.isPresent()) {
            SourceFile file = FileReader.required("script", script.get(), session.names());
            ScriptText text = ScriptText.read(file);
            if (text.script().isEmpty()) {
                return new Result(text.findings(), Optional.empty());
            }
            events = text.script().get();
        }
        PluggedDevices plugged = PluggedDevices.of(devices, session.names());
        if (!plugged.findings().isEmpty()) {
            return new Result(plugged.findings(), Optional.empty());
        }
        Optional<Refusing> inside = Optional.empty();
        if (models.isPresent()) {
            JarModels.Result made = models.get().match(program, session);
            if (made.layout().isEmpty()) {
                return new Result(made.findings(), Optional.empty());
            }
            inside = Refusing.of(made.layout());
        }
        session.progress().step("running " + jar + " on a simulated brick");
        return new Result(List.of(), Optional.of(run(program, events, plugged, inside)));
    }

    private Run run(
            JarReader program, Script events, PluggedDevices plugged, Optional<Refusing> inside) {
        LoadedProgram loaded =
                inside.map(each -> each.probed(LoadedProgram.forMany(program.program())))
                        .orElseGet(() -> LoadedProgram.forOnce(program.program()));
        try (Laboratory laboratory = new Laboratory(limits)) {
            laboratory.limit(patience);
            SimulatedBrick brick = laboratory.place(program.main(), loaded);
            Recorder recorder = recorder(inside);
            brick.observe(recorder);
            plugged.plugInto(brick);
            brick.play(events);
            laboratory.runToEnd(end(events));
            return new Run(
                    recorder.trace(),
                    laboratory.time(),
                    ending(brick.outcome().kind()),
                    brick.outcome().failure(),
                    recorder.misfits(),
                    recorder.lateness(),
                    screen(brick),
                    inside.map(each -> each.run(program.main())));
        }
    }

    private static Recorder recorder(Optional<Refusing> inside) {
        return new Recorder() {
            @Override
            public void entered(long time, Object object, String method) {
                inside.ifPresent(
                        each -> each.entered(time / VirtualTime.MILLISECOND, object, method));
            }
        };
    }

    private static String ending(Outcome.Kind kind) {
        return switch (kind) {
            case RUNNING -> "the time was over";
            case ENDED -> "the program ended";
            case STOPPED -> "the script ended";
            case ABORTED -> "ENTER and ESCAPE together broke the program off";
            case FAILED -> "the program failed";
        };
    }

    private static List<String> screen(SimulatedBrick brick) {
        List<String> rows = new ArrayList<>(brick.screen());
        while (!rows.isEmpty() && rows.get(rows.size() - 1).isBlank()) {
            rows.remove(rows.size() - 1);
        }
        return rows;
    }

    /** In milliseconds since switching on. */
    private long end(Script events) {
        if (seconds.isPresent()) {
            return seconds.getAsInt() * MILLISECONDS;
        }
        List<Step> steps = events.steps();
        if (steps.isEmpty()) {
            return USUAL;
        }
        Step last = steps.get(steps.size() - 1);
        return last.action() instanceof Action.End ? last.time() : last.time() + USUAL;
    }
}
