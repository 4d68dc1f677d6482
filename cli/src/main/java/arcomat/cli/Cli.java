package arcomat.cli;

import arcomat.cli.command.ArcomatCommand;
import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.HelpText;
import arcomat.cli.terminal.TerminalDialogue;
import arcomat.pipeline.TimeIsUp;
import arcomat.pipeline.WrongUse;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.semantics.value.GivenUp;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.ParameterException;

import java.nio.file.InvalidPathException;
import java.util.Optional;
import java.util.Set;

/** The command line without the process around it: arguments and a console in, exit status out. */
public final class Cli {
    /** Set to any text, it shows the stack trace of an internal error. */
    static final String DEBUG = "ARCOMAT_DEBUG";

    /** Where nobody says how wide a line is. */
    private static final int WIDTH = 80;

    /** The least that help can be written in. */
    private static final int NARROWEST = 55;

    private static final int WIDEST = 100;

    private Cli() {}

    public static int run(String[] args, Console console) {
        int status = execute(args, console);
        console.out().flush();
        Optional<String> loss = console.loss().get();
        loss.ifPresent(
                why ->
                        complain(
                                "standard output cannot be written, results are missing: " + why,
                                console));
        console.err().flush();
        return loss.isPresent() ? ExitStatus.WRONG_USE : status;
    }

    private static int execute(String[] args, Console console) {
        try {
            return commandLine(args, console).execute(args);
        } catch (OutOfMemoryError full) {
            return memoryIsFull(console);
        } catch (Error e) { // it would end the thread, and the process with exit status 0
            return internalError(e, console);
        }
    }

    private static CommandLine commandLine(String[] arguments, Console console) {
        Ansi ansi = console.style().coloured() ? Ansi.ON : Ansi.OFF;
        CommandLine line = new CommandLine(new ArcomatCommand(console));
        Commands commands = new Commands();
        Set<String> wanted = commands.names();
        if (arguments.length > 0 && wanted.contains(arguments[0])) {
            // Reading the annotations of the other commands would double the time of a short run.
            wanted = commands.seenBy(arguments[0]);
        }
        wanted.forEach(name -> line.addSubcommand(commands.of(name)));
        int width = helpWidth(console);
        fit(line, width);
        line.getSubcommands().values().forEach(command -> fit(command, width));
        return line.setUsageHelpWidth(width)
                .setOut(console.out())
                .setErr(console.err())
                .setColorScheme(CommandLine.Help.defaultColorScheme(ansi))
                .setExecutionStrategy(EmptyPaths::execute)
                .setParameterExceptionHandler((e, given) -> wrongArguments(e, console))
                .setExecutionExceptionHandler((e, failed, parsed) -> failure(e, console));
    }

    /** A line as long as there is room would be followed by an empty one. */
    private static void fit(CommandLine command, int width) {
        CommandLine.Model.UsageMessageSpec usage = command.getCommandSpec().usageMessage();
        usage.description(HelpText.fit(usage.description(), width - 1));
        usage.footerHeading("%nExamples:%n");
        usage.footer(HelpText.fit(usage.footer(), width - 1));
    }

    /** Help is read by people, wherever it goes; beyond a width, lines are hard to follow. */
    private static int helpWidth(Console console) {
        int width = console.style().width();
        return width == Style.PLAIN.width() ? WIDTH : Math.max(NARROWEST, Math.min(width, WIDEST));
    }

    private static int wrongArguments(ParameterException e, Console console) {
        CommandLine command = e.getCommandLine();
        complain(e.getMessage(), console);
        if (!CommandLine.UnmatchedArgumentException.printSuggestions(e, console.err())) {
            console.err().println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        }
        return ExitStatus.WRONG_USE;
    }

    private static int failure(Exception e, Console console) {
        if (e instanceof WrongUse || e instanceof TerminalDialogue.NoAnswer) {
            complain(e.getMessage(), console);
            return ExitStatus.WRONG_USE;
        }
        if (e instanceof TimeIsUp) {
            complain("unknown: " + e.getMessage() + "; allow it more with --timeout", console);
            return ExitStatus.UNKNOWN;
        }
        if (e instanceof GivenUp) {
            complain("unknown: " + e.getMessage(), console);
            return ExitStatus.UNKNOWN;
        }
        if (e instanceof InvalidPathException path) {
            complain(noName(path), console);
            return ExitStatus.WRONG_USE;
        }
        return internalError(e, console);
    }

    /** Java takes the names of files as the locale writes them, and no option changes that. */
    private static String noName(InvalidPathException path) {
        String encoding = System.getProperty("sun.jnu.encoding", "");
        String advice =
                encoding.equals("UTF-8")
                        ? ""
                        : "; Java writes names of files in "
                                + encoding
                                + " here. Set a locale of UTF-8, such as LC_ALL=C.UTF-8";
        return "'" + path.getInput() + "' cannot be the name of a file" + advice;
    }

    /** Analyses end before that; reading and writing need what they need. */
    private static int memoryIsFull(Console console) {
        long megabytes = Runtime.getRuntime().maxMemory() >> 20;
        complain(
                "unknown: memory is full. Java has "
                        + megabytes
                        + " MB; JAVA_OPTS=-Xmx"
                        + 4 * megabytes
                        + "m gives it more",
                console);
        return ExitStatus.UNKNOWN;
    }

    private static int internalError(Throwable e, Console console) {
        complain(
                "internal error, this is a fault of arcomat ("
                        + e
                        + "); please report it with the command, the models and what "
                        + DEBUG
                        + "=1 adds",
                console);
        if (System.getenv(DEBUG) != null) {
            e.printStackTrace(console.err());
        }
        return ExitStatus.WRONG_USE;
    }

    private static void complain(@Nullable String message, Console console) {
        console.err().println("arcomat: " + Printable.escape(String.valueOf(message)));
    }
}
