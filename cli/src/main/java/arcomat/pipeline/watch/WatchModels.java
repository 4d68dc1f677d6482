package arcomat.pipeline.watch;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.file.Failures;

import java.io.IOException;
import java.nio.file.FileStore;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Looks at models, and again at what a change touches, until the thread is interrupted.
 *
 * @param paths files and folders
 * @param once whether to look once and end
 * @param polling whether to look at the files again and again, and not to wait to be told
 * @param patience after which a round gives up on promises
 * @param tool whatever tells this tool from others
 * @param listener is told of everything
 */
public record WatchModels(
        List<String> paths,
        boolean once,
        boolean polling,
        Duration patience,
        String tool,
        Listener listener)
        implements Task<WatchStatus> {
    /** File systems whose files others change as well, of which nobody is told here. */
    private static final List<String> SHARED =
            List.of("nfs", "cifs", "smb", "9p", "fuse", "vboxsf", "drvfs", "afs");

    /**
     * The situation at the end.
     *
     * @throws WrongUse where a path is not there, or cannot be watched
     */
    @Override
    public WatchStatus run(Session session) throws WrongUse {
        List<String> roots = new ArrayList<>(paths);
        roots.addAll(session.libraries());
        requireThere(roots, session.names());
        WatchedFiles watched = WatchedFiles.of(roots, session.names());
        AnalysisLimits limits = new AnalysisLimits(Optional.of(patience), Optional.empty());
        Blackboard board = new Blackboard(listener);
        Rounds rounds = new Rounds(paths, session, tool, limits, watched, board);
        try {
            if (once) {
                rounds.first();
                rounds.join();
            } else {
                watch(watched, rounds);
            }
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        }
        return board.situation();
    }

    private static void requireThere(List<String> roots, PathNames names) throws WrongUse {
        for (String path : roots) {
            if (!Files.exists(names.resolve(path))) {
                throw new WrongUse("'%s' does not exist; name a model root, or models", path);
            }
        }
    }

    /** Changes count from before the first look. */
    private void watch(WatchedFiles watched, Rounds rounds) throws InterruptedException, WrongUse {
        try (Watcher watcher = watcher(watched)) {
            rounds.first();
            while (true) {
                rounds.look(watcher.await());
            }
        } catch (IOException e) {
            throw Failures.cannot("watch", String.join(", ", paths), e);
        }
    }

    private Watcher watcher(WatchedFiles watched) {
        if (!polling && watched.roots().stream().noneMatch(WatchModels::isShared)) {
            try {
                return EventWatcher.of(watched);
            } catch (IOException tooMany) {
                // Looking is slower than being told, and works everywhere.
            }
        }
        return new PollingWatcher(watched);
    }

    private static boolean isShared(Path root) {
        try {
            FileStore store = Files.getFileStore(root);
            String type = store.type().toLowerCase(Locale.ROOT);
            return SHARED.stream().anyMatch(type::startsWith);
        } catch (IOException unknown) {
            return true;
        }
    }
}
