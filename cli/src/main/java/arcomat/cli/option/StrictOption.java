package arcomat.cli.option;

import arcomat.analysis.contradiction.NoRun;
import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict.Answer;

import picocli.CommandLine.Option;

import java.util.List;

/**
 * The option {@code --strict} of commands that prove: a verdict that holds only because there is no
 * run ends them with 1.
 */
public final class StrictOption {
    @Option(
            names = "--strict",
            description = "Exit with 1 where it holds since automata leave a component no run.")
    private boolean strict;

    /** The answer to all questions: fails if one does, is unknown if one is, else holds. */
    public Answer of(List<Answered> answers) {
        return answers.stream().map(this::of).reduce(Answer.HOLDS, Answer::and);
    }

    private Answer of(Answered answered) {
        return strict && NoRun.isReasonOf(answered.verdict())
                ? Answer.FAILS
                : answered.verdict().answer();
    }
}
