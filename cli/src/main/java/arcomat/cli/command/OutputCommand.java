package arcomat.cli.command;

import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;

/** What the commands have in common that make files of one component. */
public abstract class OutputCommand<T> extends AnalysisCommand<T> {
    @Option(
            names = "--out",
            paramLabel = "DIR",
            required = true,
            description = "The folder to write, which is replaced as a whole.")
    private String out;

    @Parameters(index = "0", paramLabel = "A", description = "A component, or component#automaton.")
    private String component;

    @Parameters(
            index = "1..*",
            arity = "1..*",
            paramLabel = "PATH",
            description = "Model files and model roots.")
    private List<String> paths;

    protected final String out() {
        return out;
    }

    protected final String component() {
        return component;
    }

    protected final List<String> paths() {
        return paths;
    }
}
