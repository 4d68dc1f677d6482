package arcomat.pipeline.watch;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** Looks at times and lengths of all files, again and again, where no file system tells. */
final class PollingWatcher implements Watcher {
    private static final long PAUSE_MILLIS = 400;

    private final WatchedFiles watched;
    private Map<Path, String> before;

    PollingWatcher(WatchedFiles watched) {
        this.watched = watched;
        this.before = watched.stamps();
    }

    @Override
    public SavedFiles await() throws InterruptedException {
        Set<Path> changed = new HashSet<>();
        while (changed.isEmpty()) {
            Thread.sleep(PAUSE_MILLIS);
            Map<Path, String> now = watched.stamps();
            now.forEach(
                    (file, stamp) -> {
                        if (!stamp.equals(before.get(file))) {
                            changed.add(file);
                        }
                    });
            before.keySet().stream().filter(file -> !now.containsKey(file)).forEach(changed::add);
            before = now;
        }
        return new SavedFiles(changed);
    }

    @Override
    public void close() {}
}
