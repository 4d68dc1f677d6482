package arcomat.cli.command.watch;

import arcomat.cli.terminal.Console;
import arcomat.pipeline.watch.Listener;
import arcomat.pipeline.watch.WatchStatus;
import arcomat.pipeline.watch.WatchStatus.Step;

import java.util.Collection;

/** One line after the other, for whoever keeps them: a file, another program, a test. */
final class WatchLines implements Listener {
    /** Of each step; whoever wants all of them asks the command that is about it. */
    private static final int MOST = 20;

    private final Console console;
    private final boolean timed;

    /**
     * @param timed whether to say how long each step took
     */
    WatchLines(Console console, boolean timed) {
        this.console = console;
        this.timed = timed;
    }

    @Override
    public void changed(Collection<String> files) {
        say("\n" + StepNames.changed(files) + "\n");
    }

    @Override
    public void done(Done what, WatchStatus now) {
        WatchText text = new WatchText(now, MOST, console.style());
        Step step = what.step();
        say(
                text.broken(step)
                        + StepNames.of(step)
                        + text.summary(step)
                        + (timed ? "; " + StepNames.work(what) : "")
                        + "\n");
    }

    @Override
    public void settled(WatchStatus now) {
        say(new WatchText(now, MOST, console.style()).verdict() + "\n");
    }

    private void say(String text) {
        console.out().print(text);
        console.out().flush();
    }
}
