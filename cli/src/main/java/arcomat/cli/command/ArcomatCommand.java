package arcomat.cli.command;

import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.Version;

import picocli.CommandLine;

/** The command without a subcommand: shows what there is. */
@CommandLine.Command(
        name = "arcomat",
        versionProvider = Version.class,
        description = "Checks, runs and compiles component models with I/O automata for robots.",
        synopsisSubcommandLabel = "COMMAND",
        footer = {
            "  arcomat check models/coffee",
            "  arcomat simulate --main coffee.fetcher.Fetcher models/coffee",
            "  arcomat explain ARC0104",
            "",
            "Exit status: 0 fine; 1 findings or failed tests; 2 wrong use or unreadable input; 3"
                    + " unknown.",
            "'arcomat COMMAND --help' tells more about a command."
        })
public final class ArcomatCommand implements Runnable {
    private final Console console;

    @CommandLine.Spec private CommandLine.Model.CommandSpec spec;

    @SuppressWarnings("UnusedVariable") // picocli asks it
    @CommandLine.Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "Show this help and exit.")
    private boolean help;

    @SuppressWarnings("UnusedVariable") // picocli asks it
    @CommandLine.Option(
            names = {"-V", "--version"},
            versionHelp = true,
            description = "Show the version and exit.")
    private boolean version;

    /**
     * @param console of all commands below
     */
    public ArcomatCommand(Console console) {
        this.console = console;
    }

    Console console() {
        return console;
    }

    @Override
    public void run() {
        throw new CommandLine.ParameterException(spec.commandLine(), "a COMMAND is missing");
    }
}
