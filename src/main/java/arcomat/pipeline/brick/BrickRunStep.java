package arcomat.pipeline.brick;

import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.sim.Laboratory;
import arcomat.sim.Outcome;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.script.Action;
import arcomat.sim.script.ParsedScript;
import arcomat.sim.script.Script;
import arcomat.sim.script.ScriptError;
import arcomat.sim.script.ScriptParser;
import arcomat.sim.script.Step;
import arcomat.sim.trace.Recorder;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Runs a robot's jar on a simulated brick: the very classes that go on the brick. */
public final class BrickRunStep {
    private static final String BROKEN_SCRIPT = "ARC0808";
    private static final long MILLISECONDS = 1000;

    /** How long a run goes on where nothing says, behind the script's last line. */
    private static final long USUAL = 10_000;

    private BrickRunStep() {}

    /**
     * Runs the program, if nothing speaks against it.
     *
     * @throws WrongUse where jar or script cannot be read
     * @throws arcomat.sim.time.OutOfPatience where it takes longer than the request allows
     */
    public static BrickRunResult run(BrickRunRequest request, PathNames names, Progress progress)
            throws WrongUse {
        JarReader jar = JarReader.read(request.jar(), names);
        List<Diagnostic> obstacles = jar.report().obstacles();
        if (!obstacles.isEmpty()) {
            return new BrickRunResult(obstacles, Optional.empty());
        }
        Script script = new Script(List.of());
        if (request.script().isPresent()) {
            SourceFile file = FileReader.required("script", request.script().get(), names);
            ParsedScript parsed = ScriptParser.parse(file.text());
            if (parsed.script().isEmpty()) {
                return new BrickRunResult(findings(file, parsed.errors()), Optional.empty());
            }
            script = parsed.script().get();
        }
        PluggedDevices plugged = PluggedDevices.of(request.devices(), names);
        if (!plugged.findings().isEmpty()) {
            return new BrickRunResult(plugged.findings(), Optional.empty());
        }
        progress.step("running " + request.jar() + " on a simulated brick");
        long end = end(request, script);
        return new BrickRunResult(List.of(), Optional.of(run(jar, script, plugged, end, request)));
    }

    private static BrickRunResult.Run run(
            JarReader jar,
            Script script,
            PluggedDevices plugged,
            long end,
            BrickRunRequest request) {
        try (Laboratory laboratory = new Laboratory(request.limits())) {
            laboratory.limit(request.patience());
            SimulatedBrick brick = laboratory.place(jar.main(), jar.program());
            Recorder recorder = new Recorder();
            brick.observe(recorder);
            plugged.plugInto(brick);
            brick.play(script);
            laboratory.runToEnd(end);
            return new BrickRunResult.Run(
                    recorder.trace(),
                    laboratory.time(),
                    ending(brick.outcome().kind()),
                    brick.outcome().failure(),
                    recorder.misfits(),
                    recorder.lateness(),
                    screen(brick));
        }
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
    private static long end(BrickRunRequest request, Script script) {
        if (request.seconds().isPresent()) {
            return request.seconds().getAsInt() * MILLISECONDS;
        }
        List<Step> steps = script.steps();
        if (steps.isEmpty()) {
            return USUAL;
        }
        Step last = steps.get(steps.size() - 1);
        return last.action() instanceof Action.End ? last.time() : last.time() + USUAL;
    }

    private static List<Diagnostic> findings(SourceFile file, List<ScriptError> errors) {
        List<Integer> starts = new ArrayList<>(List.of(0));
        String[] lines = file.text().split("(?<=\\R)", -1);
        for (String line : lines) {
            starts.add(starts.get(starts.size() - 1) + line.length());
        }
        return errors.stream().map(error -> finding(file, error, starts)).toList();
    }

    private static Diagnostic finding(SourceFile file, ScriptError error, List<Integer> starts) {
        int length = file.text().length();
        int start = Math.min(starts.get(error.line() - 1) + error.column() - 1, length);
        int end = Math.min(start + error.length(), length);
        return Diagnostic.error(BROKEN_SCRIPT, file.span(start, end), error.message());
    }
}
