package arcomat.cli.command.watch;

import arcomat.cli.command.Command;
import arcomat.cli.option.LibraryOption;
import arcomat.cli.option.SecondsReader;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.SignalStatus;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.watch.Listener;
import arcomat.pipeline.watch.WatchModels;
import arcomat.pipeline.watch.WatchStatus;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/** {@code arcomat watch}: what is broken, at each save. */
@CommandLine.Command(
        name = "watch",
        description = "Checks, tests, verifies and runs what changed, at each save.",
        footer = {
            "  arcomat watch models/coffee",
            "  arcomat watch src/main/arc src/test/arc robot.world",
            "  arcomat watch --once .    everything once, for a script",
            "",
            "A check comes first. Tests, promises and worlds follow, as far as a change can touch"
                    + " them; a newer save ends what is not done. Worlds run with the first seed.",
            "",
            "On a terminal, the screen shows what is broken now. Ctrl-C ends it.",
            "",
            "Exit status: 0 all is well; 1 something is broken; 3 something is unknown, or was not"
                    + " done; 2 wrong use."
        })
public final class WatchCommand extends Command {
    @Option(names = "--once", description = "Look at everything once, and end.")
    private boolean once;

    @Option(
            names = "--poll",
            description =
                    "Look at the files again and again: for file systems that do not tell of"
                            + " changes, and for links to files elsewhere.")
    private boolean poll;

    @Option(
            names = "--timeout",
            paramLabel = "SECONDS",
            defaultValue = "60",
            converter = SecondsReader.class,
            description = "Give up on promises after that time: they are then unknown; default 60.")
    private Duration timeout;

    @Mixin private LibraryOption library = new LibraryOption();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    /** What the process ends with where it is told to end. */
    private final AtomicInteger status = new AtomicInteger(ExitStatus.UNKNOWN);

    @Override
    protected List<String> libraries() {
        return library.folders();
    }

    @Override
    protected int run(Session session) throws WrongUse {
        boolean screen = console().style().coloured() && !once;
        Listener shown = screen ? new WatchScreen(console()) : new WatchLines(console(), !once);
        WatchModels task =
                new WatchModels(paths, once, poll, timeout, Version.identity(), new Noting(shown));
        SignalStatus held = SignalStatus.of(status::get, console());
        try {
            return status(session.run(task));
        } finally {
            held.close();
        }
    }

    private static int status(WatchStatus now) {
        return switch (now.standing()) {
            case FINE -> ExitStatus.FINE;
            case BROKEN -> ExitStatus.FINDINGS;
            case UNKNOWN -> ExitStatus.UNKNOWN;
        };
    }

    /** Keeps how it stands, for the end. */
    private final class Noting implements Listener {
        private final Listener shown;

        Noting(Listener shown) {
            this.shown = shown;
        }

        @Override
        public void changed(Collection<String> files) {
            shown.changed(files);
        }

        @Override
        public void done(Done what, WatchStatus now) {
            status.set(status(now));
            shown.done(what, now);
        }

        @Override
        public void settled(WatchStatus now) {
            status.set(status(now));
            shown.settled(now);
        }
    }
}
