package arcomat.cli.command.model;

import arcomat.cli.command.Command;
import arcomat.cli.option.BaselineOptions;
import arcomat.cli.option.CheckRendering;
import arcomat.cli.option.LibraryOption;
import arcomat.cli.option.ReportOptions;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.recheck.CheckAgain;
import arcomat.pipeline.recheck.Recheck;
import arcomat.report.finding.CheckReport;
import arcomat.source.Diagnostic;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;
import java.util.Locale;

/** {@code arcomat check}: all findings about files and folders. */
@CommandLine.Command(
        name = "check",
        description = "Reports what is wrong with models.",
        footer = {
            "  arcomat check models/coffee              a model root: every model below it",
            "  arcomat check p/q/Robot.arc              one file; what it refers to is found by its"
                    + " package",
            "  arcomat check --profile executable .     is it ready for 'arcomat generate'?",
            "  arcomat check --strict --format json . > findings.json",
            "  arcomat check --format github --report sarif=build/check.sarif .",
            "  arcomat check --write-baseline known.txt .    from now on: --baseline known.txt",
            "",
            "Exit status: 0 no errors, with --strict no findings; 1 some that are not in the",
            "baseline; 2 wrong use, or input that cannot be read."
        })
public final class CheckCommand extends Command {
    /** What a model must fulfil. */
    enum Profile {
        requirements,
        executable
    }

    @Option(
            names = "--profile",
            paramLabel = "PROFILE",
            defaultValue = "requirements",
            description =
                    "What models must fulfil: ${COMPLETION-CANDIDATES}; default requirements.")
    private Profile profile;

    @Option(names = "--strict", description = "Treat warnings as errors.")
    private boolean strict;

    @Option(
            names = "--state",
            paramLabel = "FILE",
            description =
                    "Remember findings in that file, and check only what changed since the last"
                            + " time and what depends on it.")
    private String state;

    @Option(names = "--verbose", description = "Tell how many files were checked.")
    private boolean verbose;

    @Mixin private BaselineOptions baselines = new BaselineOptions();

    @Mixin private ReportOptions reports = new ReportOptions();

    @Mixin private LibraryOption library = new LibraryOption();

    @Parameters(
            paramLabel = "PATH",
            arity = "1..*",
            description = "Model files, and folders that are model roots.")
    private List<String> paths;

    @Override
    protected List<String> libraries() {
        return library.folders();
    }

    @Override
    protected int run(Session session) throws WrongUse {
        reports.prepare(session);
        CheckResult result = check(session);
        CheckReport report = baselines.apply(result, session);
        CheckRendering rendering = new CheckRendering("check", report, strict, machineFormats());
        reports.write(rendering.results(), session, console());
        if (result.hasUnreadableInput()) {
            return ExitStatus.WRONG_USE;
        }
        List<Diagnostic> findings = report.findings();
        boolean fails =
                strict ? !findings.isEmpty() : findings.stream().anyMatch(Diagnostic::isError);
        return fails ? ExitStatus.FINDINGS : ExitStatus.FINE;
    }

    private CheckResult check(Session session) throws WrongUse {
        boolean executable = profile == Profile.executable;
        return tell(
                state == null
                        ? Recheck.full(session.run(new CheckFiles(paths, executable)))
                        : session.run(
                                new CheckAgain(paths, executable, state, Version.identity())));
    }

    private CheckResult tell(Recheck recheck) {
        CheckResult result = recheck.result();
        if (verbose) {
            console()
                    .err()
                    .printf(
                            Locale.ROOT,
                            "checked %,d of %,d files\n",
                            recheck.checked().size(),
                            result.files());
        }
        return result;
    }
}
