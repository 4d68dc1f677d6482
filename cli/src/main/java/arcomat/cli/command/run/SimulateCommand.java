package arcomat.cli.command.run;

import arcomat.cli.command.Command;
import arcomat.cli.option.LibraryOption;
import arcomat.cli.option.PageOption;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.TerminalDialogue;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.simulate.Decider;
import arcomat.pipeline.simulate.SimulateComponent;
import arcomat.pipeline.simulate.SimulateComponent.Audience;
import arcomat.pipeline.simulate.SimulateComponent.Run;
import arcomat.report.run.RunText;
import arcomat.report.run.TraceCsv;
import arcomat.report.run.TraceJson;
import arcomat.report.run.TracePage;
import arcomat.report.run.TraceTable;
import arcomat.report.run.WatchedText;
import arcomat.report.text.Printable;
import arcomat.simulate.watch.Watching.Watched;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** {@code arcomat simulate}: runs a component and tells what happened, slice by slice. */
@CommandLine.Command(
        name = "simulate",
        description = "Runs a component and tells what happened, slice by slice.",
        footer = {
            "  arcomat simulate --main coffee.fetcher.Fetcher --slices 10 --seed 7 models/coffee",
            "  arcomat simulate --main 'coffee.parts.Timer(2)' --choose random models/coffee",
            "  arcomat simulate --main coffee.fig3.AvoidCrash --choose ask models/coffee",
            "  arcomat simulate --main coffee.fig6.AvoidCrash --record Run.mt models/coffee",
            "  arcomat simulate --main coffee.fig6.AvoidCrash --trace csv models/coffee > run.csv",
            "  arcomat simulate --main coffee.fig5.AvoidCrash --monitor coffee.fig3.AvoidCrash"
                    + " models/coffee",
            "  arcomat simulate --input RobotTest.mt#waits --engine compiled",
            "  arcomat simulate --input RobotTest.mt#waits --report build/run models/coffee",
            "  arcomat simulate --input RobotTest.mt#waits --why-not models/coffee",
            "",
            "Without --input, letters are drawn with the seed: the same seed, the same run.",
            "",
            "What has happened is written as the run goes on, and not kept, but for --record and",
            "--report: a run may have any number of slices.",
            "",
            "A run that errs shows in its last slice what was sent before, and no reaction.",
            "",
            "Exit status: 0 it ran, and all that was watched is kept; 1 the model went wrong, a",
            "requirement is violated, or models have errors; 3 it is unknown whether one is kept;",
            "2 wrong use, or input that cannot be read."
        })
public final class SimulateCommand extends Command {
    enum Choose {
        first,
        random,
        ask
    }

    enum Engine {
        interpreter,
        compiled
    }

    enum TraceFormat {
        table,
        csv,
        json
    }

    @Option(
            names = "--main",
            paramLabel = "QNAME",
            description =
                    "The component to run, with its arguments if it takes any: 'p.Timer(2)'. May"
                            + " be left out if --input or a single <<deploy>> component tells.")
    private String main;

    @Option(
            names = "--slices",
            paramLabel = "N",
            description = "How many slices; default: those of --input, else 20.")
    private Integer slices;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "Seed of whatever is drawn; default 1.")
    private int seed;

    @Option(
            names = "--choose",
            paramLabel = "HOW",
            defaultValue = "first",
            description =
                    "Who decides where the model leaves it open: ${COMPLETION-CANDIDATES}; default"
                            + " first.")
    private Choose choose;

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            defaultValue = "interpreter",
            description = "What runs the model: ${COMPLETION-CANDIDATES}; default interpreter.")
    private Engine engine;

    @Option(
            names = "--trace",
            paramLabel = "FORMAT",
            defaultValue = "table",
            description = "How to write what happened: ${COMPLETION-CANDIDATES}; default table.")
    private TraceFormat trace;

    @Option(
            names = "--input",
            paramLabel = "FILE.mt#test",
            description = "Take the input streams of a stream test.")
    private String input;

    @Option(
            names = "--record",
            paramLabel = "FILE.mt",
            description = "Keep the run, with the choices made, as a stream test.")
    private String record;

    @Option(
            names = "--monitor",
            paramLabel = "Q",
            description =
                    "Watch the run for the automata of this component, or component#automaton;"
                            + " may be given several times.")
    private List<String> monitors = List.of();

    @Option(
            names = "--why-not",
            description =
                    "Where no transition fired, name the one that came nearest, and what it would"
                            + " have needed. A page (--report) always has it.")
    private boolean whyNot;

    @Mixin private PageOption report = new PageOption();

    @Mixin private LibraryOption library = new LibraryOption();

    @Parameters(
            paramLabel = "PATH",
            arity = "0..*",
            description = "Model files and model roots; may be left out with --input.")
    private List<String> paths = List.of();

    @Override
    protected List<String> libraries() {
        return library.folders();
    }

    @Override
    protected int run(Session session) throws WrongUse {
        if (paths.isEmpty() && input == null) {
            throw new WrongUse("which models? name a PATH, or a test with --input");
        }
        if (slices != null && slices < 0) {
            throw new WrongUse("--slices " + slices + " is negative");
        }
        requireExplainable();
        report.prepare(session);
        CheckedAnswer<Run> reply = session.run(task());
        tellAside(reply.check());
        if (reply.value().isEmpty()) {
            return reportErrors(reply.check());
        }
        Run run = reply.value().get();
        report.write(() -> TracePage.of(run.trace(), run.watched(), how()), session);
        return report(run);
    }

    /** What was asked, for who looks at the page. */
    private String how() {
        String came = input == null ? "letters drawn with seed " + seed : "the input of " + input;
        String chosen =
                switch (choose) {
                    case first -> "the first choice";
                    case random -> "choices drawn with seed " + seed;
                    case ask -> "choices of a person";
                };
        String watched = monitors.isEmpty() ? "" : ", watched for " + String.join(", ", monitors);
        return "a run over " + came + ", with " + chosen + ", by the " + engine() + watched;
    }

    private String engine() {
        return engine == Engine.compiled ? "compiled code" : "interpreter";
    }

    private void requireExplainable() throws WrongUse {
        if (whyNot && engine == Engine.compiled) {
            throw new WrongUse(
                    "compiled code does not say why no transition fired; use --engine interpreter");
        }
        if (whyNot && trace == TraceFormat.csv) {
            throw new WrongUse("--why-not is told with --trace table and json, not with csv");
        }
    }

    private RunText text() {
        return switch (trace) {
            case table -> new TraceTable(this::print, console().style(), whyNot);
            case csv -> new TraceCsv(this::print);
            case json -> new TraceJson(this::print, whyNot);
        };
    }

    /** What fails the command: a model that goes wrong, a requirement that is violated. */
    private int report(Run run) {
        if (trace == TraceFormat.table) {
            print(WatchedText.render(run.trace(), run.watched(), console().style()));
        }
        boolean violated = false;
        boolean unknown = false;
        for (Watched watched : run.watched()) {
            violated |= watched.violation().isPresent();
            unknown |= watched.unknown().isPresent();
            if (trace != TraceFormat.table) {
                complain(watched);
            }
        }
        Optional<String> failure = run.trace().failure();
        if (failure.isPresent() && trace == TraceFormat.csv) {
            console().err().println("stopped: " + failure.get());
        }
        if (failure.isPresent() || violated) {
            return ExitStatus.FINDINGS;
        }
        return unknown ? ExitStatus.UNKNOWN : ExitStatus.FINE;
    }

    private void complain(Watched watched) {
        watched.violation()
                .ifPresent(
                        v -> console().err().println("violated: " + Printable.escape(v.message())));
        watched.unknown()
                .ifPresent(
                        why ->
                                console()
                                        .err()
                                        .println(
                                                "unknown: %s: %s"
                                                        .formatted(
                                                                Printable.escape(
                                                                        watched.requirement()),
                                                                why)));
    }

    private SimulateComponent task() {
        return new SimulateComponent(
                Optional.ofNullable(main),
                slices == null ? OptionalInt.empty() : OptionalInt.of(slices),
                seed,
                decider(),
                engine == Engine.compiled,
                Optional.ofNullable(input),
                Optional.ofNullable(record),
                monitors,
                report.isWanted(),
                whyNot || report.isWanted(),
                new Audience(text(), () -> !console().out().checkError()),
                paths);
    }

    private Decider decider() {
        return switch (choose) {
            case first -> Decider.Rule.FIRST;
            case random -> Decider.Rule.RANDOM;
            case ask -> new TerminalDialogue(console());
        };
    }
}
