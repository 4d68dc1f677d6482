package arcomat.cli;

import arcomat.pipeline.CheckResult;
import arcomat.pipeline.Pipeline;
import arcomat.report.FindingsJson;
import arcomat.report.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat check}: all findings about files and folders. */
@CommandLine.Command(
        name = "check",
        description = "Reports what is wrong with models.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat check models/coffee              a model root: every model below it",
            "  arcomat check p/q/Robot.arc              one file; what it refers to is found by its"
                    + " package",
            "  arcomat check --profile executable .     is it ready for 'arcomat generate'?",
            "  arcomat check --strict --format json . > findings.json"
        })
final class CheckCommand extends Command {
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
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "How to write findings: ${COMPLETION-CANDIDATES}; default text.")
    private OutputFormat format;

    @Parameters(
            paramLabel = "PATH",
            arity = "1..*",
            description = "Model files, and folders that are model roots.")
    private List<String> paths;

    CheckCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) {
        CheckResult result = pipeline.check(paths, profile == Profile.executable);
        if (format == OutputFormat.json) {
            print(FindingsJson.render(result.findings(), result.files()));
        } else {
            print(FindingsText.render(result.findings(), console.style()));
            printLine(FindingsText.summary(result.findings(), result.files(), console.style()));
        }
        return status(result);
    }

    private int status(CheckResult result) {
        if (result.hasUnreadableInput()) {
            return ExitStatus.WRONG_USE;
        }
        boolean fails = strict ? !result.findings().isEmpty() : result.hasErrors();
        return fails ? ExitStatus.FINDINGS : ExitStatus.FINE;
    }
}
