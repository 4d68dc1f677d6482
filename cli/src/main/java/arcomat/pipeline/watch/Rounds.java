package arcomat.pipeline.watch;

import arcomat.check.law.Profile;
import arcomat.pipeline.Interruption;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.check.WrittenNames;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.recheck.CheckMemory;
import arcomat.pipeline.recheck.Dependencies;
import arcomat.pipeline.recheck.IncrementalCheck;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * A round for each change: the check at once, by whoever waits for changes; then the slower steps
 * in a thread of their own, which ends when the next round begins.
 */
final class Rounds {
    /** As for every command: models nest as deep as their authors like. */
    private static final long STACK_BYTES = 512L << 20;

    private final List<String> paths;
    private final Session session;
    private final String tool;
    private final AnalysisLimits limits;
    private final WatchedFiles watched;
    private final Blackboard board;
    private final CheckMemory memory;
    private Interruption current = new Interruption();
    private @Nullable Thread slow;

    Rounds(
            List<String> paths,
            Session session,
            String tool,
            AnalysisLimits limits,
            WatchedFiles watched,
            Blackboard board) {
        this.paths = paths;
        this.session = session.with(Progress.NONE);
        this.memory = new CheckMemory(session.guests());
        this.tool = tool;
        this.limits = limits;
        this.watched = watched;
        this.board = board;
    }

    /** Everything. */
    void first() {
        look(List.of(), true);
    }

    void look(SavedFiles change) {
        look(change.files(), false);
    }

    private void look(Collection<Path> changed, boolean all) {
        long begun = System.nanoTime();
        current.end();
        if (!all) {
            board.changed(changed.stream().map(this::shown).sorted().toList());
        }
        memory.forget(changed);
        IncrementalCheck.Outcome outcome =
                new IncrementalCheck(paths, Profile.REQUIREMENTS, tool, session).run(memory);
        board.checked(
                outcome.result(), outcome.checked(), outcome.state(), System.nanoTime() - begun);
        Dependencies files = Dependencies.of(outcome.state());
        touchWorlds(changed, outcome.checked(), files, all);
        begin(files);
    }

    private void begin(Dependencies files) {
        current = new Interruption();
        Runnable steps = new SlowSteps(board, files, session.with(current), limits, current);
        Thread thread = new Thread(null, steps, "arcomat-watch", STACK_BYTES);
        thread.setDaemon(true);
        thread.start();
        slow = thread;
    }

    /** Until the steps of the last round are done. */
    void join() throws InterruptedException {
        if (slow != null) {
            slow.join();
        }
    }

    private void touchWorlds(
            Collection<Path> changed, List<String> models, Dependencies files, boolean all) {
        Map<String, Path> there = new TreeMap<>();
        watched.stamps().keySet().stream()
                .filter(WatchedFiles::isWorld)
                .forEach(file -> there.put(shown(file), file));
        boolean beside = changed.stream().anyMatch(WatchedFiles::isBeside);
        Set<String> touched = new TreeSet<>();
        there.forEach(
                (name, file) -> {
                    if (all || beside || changed.contains(file) || uses(file, models, files)) {
                        touched.add(name);
                    }
                });
        board.touchedWorlds(touched, there.keySet());
    }

    /** Whether the text of a world names one of the models. */
    private boolean uses(Path world, List<String> models, Dependencies files) {
        return FileReader.read(world, shown(world))
                .file()
                .filter(text -> files.isMentioned(models, WrittenNames.in(text.text())))
                .isPresent();
    }

    private String shown(Path file) {
        return session.names()
                .shown(file, paths.stream().anyMatch(each -> Path.of(each).isAbsolute()));
    }
}
