package arcomat.cli.command;

import arcomat.model.Automaton.Completion;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.ComparedSides;

import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
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

    protected final ComparedSides sides() throws WrongUse {
        String[] sides = completion == null ? new String[0] : completion.split(",", -1);
        if (completion != null && sides.length != 2) {
            throw new WrongUse("--completion '" + completion + "' is no pair such as chaos,output");
        }
        return new ComparedSides(left, right, completion(sides, 0), completion(sides, 1));
    }

    private static Optional<Completion> completion(String[] sides, int side) throws WrongUse {
        if (sides.length == 0) {
            return Optional.empty();
        }
        String name = sides[side].strip();
        return Optional.of(
                Arrays.stream(Completion.values())
                        .filter(c -> c.name().toLowerCase(Locale.ROOT).equals(name))
                        .findFirst()
                        .orElseThrow(
                                () ->
                                        new WrongUse(
                                                "'%s' is no completion; there are chaos, output,"
                                                        + " ignore and error",
                                                name)));
    }
}
