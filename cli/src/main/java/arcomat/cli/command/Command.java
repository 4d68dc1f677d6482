package arcomat.cli.command;

import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.MachineFormats;
import arcomat.cli.terminal.ProgressLines;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.guest.WelcomeGuests;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;

import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.ToIntFunction;

/** What the commands have in common: a console, a session, and help. */
public abstract class Command implements Callable<Integer> {
    @ParentCommand private ArcomatCommand tool;

    @SuppressWarnings("UnusedVariable") // picocli asks it
    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "Show this help and exit.")
    private boolean help;

    @Option(
            names = "--progress",
            description =
                    "Tell what long work is at, also where nobody looks on; default: on a"
                            + " terminal.")
    private boolean progress;

    @Option(
            names = "--with",
            paramLabel = "GUEST",
            description =
                    "A jar, or a folder of classes, that brings laws, questions about automata,"
                            + " languages, forms of reports, or the reading of other models;"
                            + " may be repeated.")
    private List<String> guests = new ArrayList<>();

    @SuppressWarnings("NullAway.Init") // there is none before the command is called
    private Session session;

    @Override
    public final Integer call() throws WrongUse {
        if (!progress && !console().watched()) {
            return run(limited(Progress.NONE));
        }
        try (ProgressLines lines = new ProgressLines(console().err())) {
            return run(limited(lines));
        }
    }

    private int run(Progress limited) throws WrongUse {
        session = Session.in(console().directory(), limited).with(libraries());
        if (!guests.isEmpty()) {
            session = session.with(session.run(new WelcomeGuests(guests)));
        }
        return run(session);
    }

    /** Model roots of others that the models may refer to. */
    protected List<String> libraries() {
        return List.of();
    }

    /** Results for programs that show every kind of finding in one way. */
    protected final MachineFormats machineFormats() {
        return MachineFormats.of(console(), session);
    }

    /** Work that ends when it has to. */
    protected Progress limited(Progress progress) throws WrongUse {
        return progress;
    }

    protected final Console console() {
        return tool.console();
    }

    /** Does the work and returns the exit status. */
    protected abstract int run(Session session) throws WrongUse;

    /** Prints findings that keep a command from doing its work. */
    protected final int reportErrors(CheckResult check) {
        print(FindingsText.render(check.findings(), console().style()));
        printLine(FindingsText.summary(check.findings(), check.files(), console().style()));
        return check.hasUnreadableInput() ? ExitStatus.WRONG_USE : ExitStatus.FINDINGS;
    }

    /**
     * Tells which files were written, or which findings do not let that be done.
     *
     * @param told tells more about what was written, and returns how many files there are
     * @param out the folder, as the user wrote it
     */
    protected final <T> int tellWritten(
            CheckedAnswer<T> written, ToIntFunction<T> told, String out) {
        tellAside(written.check());
        if (written.value().isEmpty()) {
            return reportErrors(written.check());
        }
        print(FindingsText.render(written.check().findings(), console().style()));
        int files = told.applyAsInt(written.value().get());
        printLine("wrote " + FindingsText.count(files, "file") + " to " + out);
        return ExitStatus.FINE;
    }

    /** Tells what a command went on without; what it found out is for the standard output. */
    protected final void tellAside(CheckResult check) {
        tellAside(check.aside());
    }

    /** The same of files from several places. */
    protected final void tellAside(Aside aside) {
        if (!aside.isEmpty()) {
            console().err().print(FindingsText.render(aside.findings(), console().style()));
            console()
                    .err()
                    .println(
                            "left out, with errors or in need of a file that has: "
                                    + Printable.escape(String.join(", ", aside.files())));
        }
    }

    protected final void print(String text) {
        console().out().print(text);
    }

    protected final void printLine(String text) {
        console().out().print(text + "\n");
    }
}
