package arcomat.cli;

import arcomat.analysis.Verdict.Answer;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.step.WrongUse;

import picocli.CommandLine.Option;

import java.util.Optional;

/** A command that may search for long, and gives up where it is told to. */
abstract class LimitedCommand extends Command {
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

    LimitedCommand(Console console) {
        super(console);
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
}
