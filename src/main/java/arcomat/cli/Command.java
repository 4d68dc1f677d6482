package arcomat.cli;

import arcomat.pipeline.Pipeline;
import arcomat.pipeline.WrongUse;

import picocli.CommandLine.Option;

import java.util.concurrent.Callable;

/** What the commands have in common: a console, a pipeline, and help. */
abstract class Command implements Callable<Integer> {
    final Console console;

    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "Show this help and exit.")
    private boolean help;

    Command(Console console) {
        this.console = console;
    }

    @Override
    public final Integer call() throws WrongUse {
        try (ProgressLines progress = new ProgressLines(console.err())) {
            return run(new Pipeline(console.directory(), progress));
        }
    }

    /** Does the work and returns the exit status. */
    abstract int run(Pipeline pipeline) throws WrongUse;

    final void print(String text) {
        console.out().print(text);
    }

    final void printLine(String text) {
        console.out().print(text + "\n");
    }
}
