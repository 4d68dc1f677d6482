package arcomat.pipeline.watch;

import java.io.IOException;
import java.nio.file.ClosedWatchServiceException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchEvent;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;

/**
 * Is told by the file system. Every folder has to be registered; what was written into a new one
 * before that is found by looking. A save is several events: what comes until it has been quiet for
 * a moment is one change.
 */
final class EventWatcher implements Watcher {
    private static final long QUIET_MILLIS = 15;

    /** Who never pauses is told in between. */
    private static final long LONGEST_NANOS = TimeUnit.MILLISECONDS.toNanos(300);

    private static final WatchEvent.Kind<?>[] KINDS = {
        StandardWatchEventKinds.ENTRY_CREATE,
        StandardWatchEventKinds.ENTRY_MODIFY,
        StandardWatchEventKinds.ENTRY_DELETE
    };

    private final WatchedFiles watched;
    private final WatchService service;
    private final Map<WatchKey, Path> folders = new HashMap<>();

    private EventWatcher(WatchedFiles watched, WatchService service) {
        this.watched = watched;
        this.service = service;
    }

    /**
     * Begins to listen.
     *
     * @throws IOException where the file system tells nobody, or not of so many folders
     */
    static EventWatcher of(WatchedFiles watched) throws IOException {
        EventWatcher watcher =
                new EventWatcher(watched, FileSystems.getDefault().newWatchService());
        try {
            for (Path root : watched.roots()) {
                watcher.registerRoot(root);
            }
            return watcher;
        } catch (IOException refused) {
            watcher.close();
            throw refused;
        }
    }

    /** A root may go and come again: its parent tells. */
    private void registerRoot(Path root) throws IOException {
        Path parent = root.toAbsolutePath().getParent();
        if (parent != null && Files.isDirectory(parent)) {
            register(parent);
        }
        if (Files.isDirectory(root)) {
            registerAll(root);
        }
    }

    /** A folder that is made while its parent is not yet registered is found by looking again. */
    private void registerAll(Path top) throws IOException {
        Set<Path> registered = new HashSet<>();
        Set<Path> fresh = WatchedFiles.foldersIn(top);
        while (!fresh.isEmpty()) {
            for (Path folder : fresh) {
                register(folder);
            }
            registered.addAll(fresh);
            fresh = WatchedFiles.foldersIn(top);
            fresh.removeAll(registered);
        }
    }

    private void register(Path folder) throws IOException {
        try {
            folders.put(folder.register(service, KINDS), folder);
        } catch (NoSuchFileException | NotDirectoryException gone) {
            // It has been, and nothing is in it any more.
        }
    }

    @Override
    public SavedFiles await() throws InterruptedException, IOException {
        Set<Path> changed = new HashSet<>();
        try {
            while (changed.isEmpty()) {
                collect(service.take(), changed);
            }
            long end = System.nanoTime() + LONGEST_NANOS;
            WatchKey next = service.poll(QUIET_MILLIS, TimeUnit.MILLISECONDS);
            while (next != null) {
                collect(next, changed);
                next =
                        System.nanoTime() < end
                                ? service.poll(QUIET_MILLIS, TimeUnit.MILLISECONDS)
                                : null;
            }
        } catch (ClosedWatchServiceException closed) {
            throw new InterruptedException("nobody watches any longer");
        }
        return new SavedFiles(changed);
    }

    private void collect(WatchKey key, Set<Path> changed) throws IOException {
        Path folder = folders.get(key);
        for (WatchEvent<?> event : key.pollEvents()) {
            if (folder == null) {
                continue;
            }
            if (event.kind() == StandardWatchEventKinds.OVERFLOW) {
                changed.addAll(watched.stamps().keySet()); // too many to be told: any
                continue;
            }
            note(folder.resolve((Path) event.context()), event.kind(), changed);
        }
        if (!key.reset()) {
            folders.remove(key);
        }
    }

    private void note(Path path, WatchEvent.Kind<?> kind, Set<Path> changed) throws IOException {
        if (!watched.contains(path)) {
            return;
        }
        if (kind == StandardWatchEventKinds.ENTRY_CREATE && Files.isDirectory(path)) {
            registerAll(path);
            changed.add(path);
        } else if (WatchedFiles.matters(path) || folders.containsValue(path)) {
            changed.add(path);
        }
    }

    @Override
    public void close() throws IOException {
        service.close();
    }
}
