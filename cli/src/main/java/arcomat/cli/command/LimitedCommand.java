package arcomat.cli.command;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.cli.option.LibraryOption;
import arcomat.cli.option.SecondsReader;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.LastMoment;
import arcomat.pipeline.LimitedProgress;
import arcomat.pipeline.Progress;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.sim.time.SecondsText;

import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

import java.time.Duration;
import java.util.List;
import java.util.Optional;

/** A command that may search for long, and gives up where it is told to. */
public abstract class LimitedCommand extends Command {
    @Option(
            names = "--timeout",
            paramLabel = "SECONDS",
            converter = SecondsReader.class,
            description = "Give up after that time: the answer is then unknown.")
    private Duration timeout;

    @Option(
            names = "--max-states",
            paramLabel = "N",
            description = "Give up after that many states; default: what memory holds.")
    private Long maxStates;

    @Mixin private LibraryOption library = new LibraryOption();

    /** A command is made to be run at once. */
    private final long begun = System.nanoTime();

    @Override
    protected final List<String> libraries() {
        return library.folders();
    }

    /** What comes before the search is over by then, too. */
    @Override
    protected final Progress limited(Progress progress) throws WrongUse {
        Optional<Long> end = limits().end(begun);
        if (isTimeOfAll()) {
            end.ifPresent(moment -> LastMoment.await(moment, console()));
        }
        return end.isPresent() ? new LimitedProgress(progress, end.get()) : progress;
    }

    /** Whether the time is that of the whole command, and not of each search in it alone. */
    protected boolean isTimeOfAll() {
        return true;
    }

    protected final AnalysisLimits limits() throws WrongUse {
        if (maxStates != null && maxStates < 1) {
            throw new WrongUse("--max-states " + maxStates + " is less than 1");
        }
        return new AnalysisLimits(
                Optional.ofNullable(timeout), Optional.ofNullable(maxStates), Optional.of(begun));
    }

    /** The limits in words, for who looks at a page. */
    protected final String limitsInWords() {
        String time = timeout == null ? "no limit of time" : SecondsText.of(timeout) + " s";
        return time
                + ", "
                + (maxStates == null ? "as many states as memory holds" : maxStates + " states");
    }

    protected static int status(Answer answer) {
        return switch (answer) {
            case HOLDS -> ExitStatus.FINE;
            case FAILS -> ExitStatus.FINDINGS;
            case UNKNOWN -> ExitStatus.UNKNOWN;
        };
    }
}
