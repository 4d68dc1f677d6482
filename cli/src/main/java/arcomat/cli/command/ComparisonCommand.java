package arcomat.cli.command;

import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.ComparedSides;

import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;
import java.util.Optional;

/** What the commands about two sides have in common. */
public abstract class ComparisonCommand<T> extends AnalysisCommand<T> {
    @Option(
            names = "--completion",
            paramLabel = "LEFT,RIGHT",
            description = {
                "What A and B do where no transition fits, instead of what the models say:",
                "chaos, output, ignore or error."
            })
    private String completion;

    @Parameters(index = "0", paramLabel = "A", description = "A component, or component#automaton.")
    private String left;

    @Parameters(index = "1", paramLabel = "B", description = "What A is to keep.")
    private String right;

    @Parameters(
            index = "2..*",
            arity = "1..*",
            paramLabel = "PATH",
            description = "Model files and model roots.")
    private List<String> paths;

    protected final List<String> paths() {
        return paths;
    }

    /** Both sides, for a headline. */
    protected final String title() {
        return left + " and " + right;
    }

    protected final ComparedSides sides() throws WrongUse {
        return ComparedSides.of(left, right, Optional.ofNullable(completion));
    }
}
