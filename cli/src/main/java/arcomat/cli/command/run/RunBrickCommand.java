package arcomat.cli.command.run;

import arcomat.cli.command.Command;
import arcomat.cli.option.BrickRunOptions;
import arcomat.cli.option.LibraryOption;
import arcomat.cli.option.PageOption;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.brick.JarModels;
import arcomat.pipeline.brick.RunJar;
import arcomat.pipeline.file.FileFindings;
import arcomat.report.brick.BrickPage;
import arcomat.report.brick.BrickTraceJson;
import arcomat.report.brick.BrickTraceText;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;
import arcomat.sim.time.OutOfPatience;
import arcomat.sim.trace.Recorder.Misfit;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** {@code arcomat run-brick}: runs a robot's jar on a simulated brick. */
@CommandLine.Command(
        name = "run-brick",
        description = "Runs a robot's jar on a simulated brick, faster than real time.",
        footer = {
            "  arcomat run-brick --jar build/brick/Fetcher.jar --script meets-another.script",
            "  arcomat run-brick --jar build/brick/Fetcher.jar --seconds 60 --trace csv > run.csv",
            "  arcomat run-brick --jar build/brick/Fetcher.jar --models models/coffee --report"
                    + " build/run",
            "  arcomat run-brick --jar build/brick/Rover.jar --device S2=simulation/Gyro.java",
            "",
            "A script has one line per event: milliseconds since switching on, what, and how.",
            "  0     S1 255              a sensor's value in its own unit",
            "  1500  S4 pressed          also released, unplugged, raw 612",
            "  3000  button ESCAPE       pressed for a moment; also ESCAPE 800, ESCAPE down, up",
            "  10000 end",
            "",
            "Exit status: 0 the program ran; 1 it went wrong, or cannot run on the brick; 3 it was",
            "given up; 2 wrong use."
        })
public final class RunBrickCommand extends Command {
    enum TraceFormat {
        table,
        csv,
        json
    }

    private static final int LONGEST = Integer.MAX_VALUE / 1000;

    @Option(
            names = "--jar",
            paramLabel = "ROBOT.jar",
            required = true,
            description = "The program, as 'generate --target lejos' makes it.")
    private String jar;

    @Option(
            names = "--script",
            paramLabel = "FILE",
            description = "What happens to the brick; without it, nothing.")
    private String script;

    @Option(
            names = "--device",
            paramLabel = "SOCKET=DEVICE",
            description =
                    "What is plugged into a socket and asked over I2C: a Java file that describes"
                            + " it, or ultrasonic, compass, thermometer. May be repeated.")
    private Map<SensorName, String> devices = new EnumMap<>(SensorName.class);

    @Option(
            names = "--seconds",
            paramLabel = "N",
            description =
                    "How long at most, in the brick's time; default: to the script's end, or 10"
                            + " seconds behind its last line.")
    private Integer seconds;

    @Option(
            names = "--trace",
            paramLabel = "FORMAT",
            defaultValue = "table",
            description =
                    "How to write what happened: ${COMPLETION-CANDIDATES}; default table, which"
                            + " leaves out cycles that change nothing.")
    private TraceFormat trace;

    @Option(
            names = "--models",
            paramLabel = "PATH",
            description =
                    "A model file or model root that the jar was made of: the page of --report"
                            + " also shows what its parts and automata do. May be repeated.")
    private List<String> models = new ArrayList<>();

    @Option(
            names = "--main",
            paramLabel = "QNAME",
            description =
                    "The component of these models that the jar runs, as 'generate --main' was"
                            + " told; default: the one whose program is called as the jar's.")
    private String main;

    @Mixin private LibraryOption library = new LibraryOption();

    @Mixin private BrickRunOptions bricks = new BrickRunOptions();

    @Mixin private PageOption report = new PageOption();

    @Override
    protected List<String> libraries() {
        return library.folders();
    }

    @Override
    protected int run(Session session) throws WrongUse {
        if (!models.isEmpty() && !report.isWanted()) {
            throw new WrongUse("what models do stands on a page; say where with --report DIR");
        }
        if (main != null && models.isEmpty()) {
            throw new WrongUse("--main names a component of models; say which with --models PATH");
        }
        if (seconds != null && seconds < 1) {
            throw new WrongUse("--seconds " + seconds + " is less than 1");
        }
        if (seconds != null && seconds > LONGEST) {
            throw new WrongUse(
                    "--seconds %d is more than %d, where the brick's clock of milliseconds ends",
                    seconds, LONGEST);
        }
        report.prepare(session);
        OptionalInt limit = seconds == null ? OptionalInt.empty() : OptionalInt.of(seconds);
        RunJar task =
                new RunJar(
                        jar,
                        Optional.ofNullable(script),
                        devices,
                        limit,
                        bricks.patience(),
                        bricks.limits(),
                        models.isEmpty()
                                ? Optional.empty()
                                : Optional.of(new JarModels(models, Optional.ofNullable(main))));
        try {
            return report(session.run(task), session);
        } catch (OutOfPatience e) {
            return BrickRunOptions.gaveUp(e, console());
        }
    }

    private int report(RunJar.Result result, Session session) throws WrongUse {
        if (result.run().isEmpty()) {
            print(FindingsText.render(result.findings(), console().style()));
            printLine(FindingsText.summary(result.findings(), 1, console().style()));
            return result.findings().stream().anyMatch(FileFindings::isUnreadableInput)
                    ? ExitStatus.WRONG_USE
                    : ExitStatus.FINDINGS;
        }
        RunJar.Run run = result.run().get();
        report.write(
                () ->
                        BrickPage.of(
                                jar,
                                run.trace(),
                                run.ending(),
                                run.failure(),
                                run.lateness(),
                                run.screen(),
                                run.inside()),
                session);
        return report(run);
    }

    private int report(RunJar.Run run) {
        switch (trace) {
            case table -> {
                print(BrickTraceText.render(run.trace(), console().style()));
                run.screen().forEach(row -> printLine("| " + Printable.escape(row)));
                printLine(summary(run));
                if (run.lateness().slices() > 0) {
                    printLine(BrickTraceText.of(run.lateness()));
                }
            }
            case csv -> print(BrickTraceText.csv(run.trace()));
            case json -> print(BrickTraceJson.render(run.trace()));
        }
        for (Misfit misfit : run.misfits()) {
            console().err().println(told(misfit));
        }
        if (run.lateness().slices() > 0 && trace != TraceFormat.table) {
            console().err().println(BrickTraceText.of(run.lateness()));
        }
        if (run.failure().isPresent()) {
            console().err().println("stopped: " + Printable.escape(run.failure().get()));
            return ExitStatus.FINDINGS;
        }
        return run.misfits().isEmpty() ? ExitStatus.FINE : ExitStatus.FINDINGS;
    }

    private static String told(Misfit misfit) {
        Stimulus stimulus = misfit.stimulus();
        String exposed =
                switch (stimulus.kind()) {
                    case SWITCH -> stimulus.number() == 0 ? "released" : "pressed";
                    case COLOR -> "a colour";
                    case RAW -> "raw " + stimulus.number();
                    default -> "" + stimulus.number();
                };
        return "%s is read as %s at %d ms, which cannot sense what the script exposes it to: %s"
                .formatted(misfit.socket(), misfit.sensor(), misfit.time() / 1000, exposed);
    }

    private static String summary(RunJar.Run run) {
        return String.format(
                Locale.ROOT, "%s after %.1f s", run.ending(), run.milliseconds() / 1000.0);
    }
}
