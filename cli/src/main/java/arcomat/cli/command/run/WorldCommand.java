package arcomat.cli.command.run;

import arcomat.cli.command.Command;
import arcomat.cli.option.BrickRunOptions;
import arcomat.cli.option.LibraryOption;
import arcomat.cli.option.OutputFormat;
import arcomat.cli.option.SeedOptions;
import arcomat.cli.option.SetOption;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.ReportPage;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.pipeline.world.PreparedWorld.Explained;
import arcomat.pipeline.world.WriteAnimation;
import arcomat.pipeline.world.WriteReplay;
import arcomat.report.finding.FindingsJson;
import arcomat.report.finding.FindingsText;
import arcomat.report.world.Ghost;
import arcomat.report.world.WorldRunJson;
import arcomat.report.world.WorldText;
import arcomat.sim.time.OutOfPatience;
import arcomat.world.Recording;
import arcomat.world.Seeds;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;
import java.util.Optional;

/** {@code arcomat world}: robots on a floor. */
@CommandLine.Command(
        name = "world",
        description =
                "Runs the robots of a world: their programs on simulated bricks, on one floor.",
        footer = {
            "  arcomat world models/coffee/world/meeting.world",
            "  arcomat world models/coffee/world/service.world --seed 7 --report build/service",
            "  arcomat world models/coffee/world/meeting.world --runs 100",
            "  arcomat world yard.world --seed 2 --report two --ghost one/recording.json",
            "  arcomat world yard.world --set speed=200 --set light=2.5",
            "",
            "Exit status: 0 all went well; 1 robots collided, a program failed, the world's goal"
                    + " was not reached, or there are errors in the world or its models; 3 a run"
                    + " was given up; 2 wrong use."
        })
public final class WorldCommand extends Command {
    @Mixin private LibraryOption library = new LibraryOption();

    @Parameters(
            paramLabel = "FILE.world",
            description = "The world; docs/world.md tells how to write one.")
    private String world;

    @Mixin private SeedOptions seeds = new SeedOptions();

    @Option(
            names = "--report",
            paramLabel = "DIR",
            description =
                    "Write a page that plays the run again, DIR/index.html, and the recording.")
    private String report;

    @Option(
            names = "--ghost",
            paramLabel = "RECORDING.json",
            description =
                    "Show another run on the floor of the page, of another seed or another version:"
                            + " the recording that --report has written of it.")
    private String ghost;

    @Option(
            names = "--animation",
            paramLabel = "FILE.svg",
            description =
                    "Write the run as one picture that moves, for pages of others; it has no"
                            + " script.")
    private String animation;

    @Option(
            names = "--runs",
            paramLabel = "N",
            defaultValue = "1",
            description = "Run with N seeds, this one and the next; tell only how each ended.")
    private int runs;

    @Option(
            names = "--run-devices",
            description =
                    "Compile and run the Java files that the world names as devices. They run with"
                            + " your rights: look at them first.")
    private boolean runDevices;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "How to tell of the run: ${COMPLETION-CANDIDATES}; default text.")
    private OutputFormat format;

    @Mixin private SetOption set = new SetOption();

    @Mixin private BrickRunOptions bricks = new BrickRunOptions();

    @Override
    protected List<String> libraries() {
        return library.folders();
    }

    @Override
    protected int run(Session session) throws WrongUse {
        if (runs < 1) {
            throw new WrongUse("--runs " + runs + " is less than 1");
        }
        if (runs > 1 && (report != null || animation != null)) {
            throw new WrongUse(
                    (report != null ? "--report" : "--animation")
                            + " shows one run; choose it with --seed, without --runs");
        }
        if (runs > 1 && !seeds.isSingle()) {
            throw new WrongUse("--then is about one run; choose it with --seed, without --runs");
        }
        if (runs > 1 && format == OutputFormat.json) {
            throw new WrongUse(
                    "--format json tells one run; 'arcomat campaign' has tables of many");
        }
        if (ghost != null && report == null) {
            throw new WrongUse("--ghost is shown on a page; say where it goes with --report DIR");
        }
        Optional<Ghost> other = Optional.empty();
        if (ghost != null) {
            other = Optional.of(WriteReplay.ghost(ghost, session));
        }
        Seeds drawn = seeds.seeds();
        if (report != null) {
            new ReportPage(report, session.names()).requireWritable();
        }
        PreparedWorld prepared = session.run(new PrepareWorld(world, runDevices, set.values()));
        tellAside(prepared.aside());
        tellFindings(prepared);
        if (!prepared.canRun()) {
            return ExitStatus.FINDINGS;
        }
        try {
            return runs == 1 ? runOnce(prepared, drawn, other, session) : runOften(prepared);
        } catch (OutOfPatience e) {
            return BrickRunOptions.gaveUp(e, console());
        }
    }

    private int runOnce(PreparedWorld prepared, Seeds drawn, Optional<Ghost> other, Session session)
            throws WrongUse {
        Explained run =
                report == null
                        ? new Explained(
                                prepared.run(drawn, bricks.patience(), bricks.limits()), List.of())
                        : prepared.explain(drawn, bricks.patience(), bricks.limits());
        Recording recording = run.recording();
        tell(recording, prepared);
        String title = world + ", " + seeds.shown() + set.shown();
        if (report != null) {
            tellWritten(
                    session.run(new WriteReplay(recording, run.inside(), other, title, report)));
        }
        if (animation != null) {
            tellWritten(session.run(new WriteAnimation(recording, title, animation)));
        }
        return status(recording.succeeded());
    }

    private void tellWritten(String path) {
        if (format == OutputFormat.text) {
            printLine("wrote " + path);
        }
    }

    /** A program reads one text: that of the run, or that of the findings that do not let it be. */
    private void tellFindings(PreparedWorld prepared) {
        if (format == OutputFormat.json) {
            if (!prepared.canRun()) {
                print(FindingsJson.render(prepared.findings(), prepared.files()));
            }
            return;
        }
        print(FindingsText.render(prepared.findings(), console().style()));
        if (!prepared.canRun()) {
            printLine(
                    FindingsText.summary(prepared.findings(), prepared.files(), console().style()));
        }
    }

    private void tell(Recording recording, PreparedWorld prepared) {
        if (format == OutputFormat.json) {
            print(WorldRunJson.render(world, recording, prepared.findings()));
            return;
        }
        print(WorldText.events(recording, console().style()));
        printLine("");
        printLine(WorldText.summary(recording));
    }

    private int runOften(PreparedWorld prepared) throws WrongUse {
        int good = 0;
        long first = seeds.first();
        for (long each = first; each < first + runs; each++) {
            Recording recording = prepared.run(Seeds.of(each), bricks.patience(), bricks.limits());
            good += recording.succeeded() ? 1 : 0;
            printLine("seed " + each + ": " + WorldText.summary(recording));
        }
        printLine(good + " of " + runs + " runs succeeded");
        return status(good == runs);
    }

    private static int status(boolean succeeded) {
        return succeeded ? ExitStatus.FINE : ExitStatus.FINDINGS;
    }
}
