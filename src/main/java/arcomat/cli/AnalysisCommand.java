package arcomat.cli;

import arcomat.analysis.Verdict.Answer;
import arcomat.pipeline.AnalysisLimits;
import arcomat.pipeline.WrongUse;
import arcomat.report.FindingsJson;

import picocli.CommandLine.Option;

import java.util.Optional;

/** What the commands that answer questions about models have in common. */
abstract class AnalysisCommand extends Command {
    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "How to write answers: ${COMPLETION-CANDIDATES}; default text.")
    private OutputFormat format;

    @Option(
            names = "--timeout",
            paramLabel = "SECONDS",
            description = "Give up after that time: the answer is then unknown.")
    private Integer timeout;

    @Option(
            names = "--max-states",
            paramLabel = "N",
            description = "Give up after that many states; default: what memory holds.")
    private Long maxStates;

    AnalysisCommand(Console console) {
        super(console);
    }

    final boolean isJson() {
        return format == OutputFormat.json;
    }

    final AnalysisLimits limits() throws WrongUse {
        if (timeout != null && timeout < 1) {
            throw new WrongUse("--timeout " + timeout + " is less than 1");
        }
        if (maxStates != null && maxStates < 1) {
            throw new WrongUse("--max-states " + maxStates + " is less than 1");
        }
        return new AnalysisLimits(Optional.ofNullable(timeout), Optional.ofNullable(maxStates));
    }

    static int status(Answer answer) {
        return switch (answer) {
            case HOLDS -> ExitStatus.FINE;
            case FAILS -> ExitStatus.FINDINGS;
            case UNKNOWN -> ExitStatus.UNKNOWN;
        };
    }

    /** Models with errors cannot be asked anything: their findings are the answer. */
    final int refuse(arcomat.pipeline.CheckResult check) {
        if (isJson()) {
            print(FindingsJson.render(check.findings(), check.files()));
        } else {
            reportErrors(check);
        }
        return ExitStatus.WRONG_USE;
    }
}
