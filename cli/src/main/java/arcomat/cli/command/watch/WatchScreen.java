package arcomat.cli.command.watch;

import arcomat.cli.terminal.Console;
import arcomat.pipeline.watch.Listener;
import arcomat.pipeline.watch.WatchStatus;
import arcomat.pipeline.watch.WatchStatus.Step;

import java.util.Collection;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * A terminal that shows what is broken now, and nothing that was. The last lines, which never
 * scroll away, say how each step stands, and what was done last.
 */
final class WatchScreen implements Listener {
    /** Of each step; a screen has no room for more. */
    private static final int MOST = 4;

    private static final String CLEAR = "\u001b[H\u001b[2J\u001b[3J";

    private final Console console;
    private final Map<Step, Done> last = new EnumMap<>(Step.class);
    private String saved = "";

    WatchScreen(Console console) {
        this.console = console;
    }

    @Override
    public void changed(Collection<String> files) {
        saved = StepNames.changed(files);
        last.clear();
    }

    @Override
    public void done(Done what, WatchStatus now) {
        last.put(what.step(), what);
        show(now, "");
    }

    @Override
    public void settled(WatchStatus now) {
        show(now, new WatchText(now, MOST, console.style()).verdict());
    }

    private void show(WatchStatus now, String verdict) {
        WatchText text = new WatchText(now, MOST, console.style());
        StringBuilder screen = new StringBuilder(CLEAR);
        for (Step step : Step.values()) {
            screen.append(text.broken(step));
        }
        for (Step step : Step.values()) {
            String summary = text.summary(step);
            if (!summary.isEmpty()) {
                screen.append(StepNames.of(step)).append(summary).append(work(step)).append('\n');
            }
        }
        List.of(saved, verdict).stream()
                .filter(line -> !line.isEmpty())
                .forEach(line -> screen.append(line).append('\n'));
        screen.append(console.style().quiet("Ctrl-C ends")).append('\n');
        console.out().print(screen);
        console.out().flush();
    }

    private String work(Step step) {
        Done done = last.get(step);
        return done == null ? "" : console.style().quiet("   " + StepNames.work(done));
    }
}
