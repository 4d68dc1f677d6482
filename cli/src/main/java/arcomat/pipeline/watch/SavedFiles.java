package arcomat.pipeline.watch;

import java.nio.file.Path;
import java.util.Set;

/**
 * What happened to files since the last time.
 *
 * @param files with other contents, new or gone; folders where what is in them may be new
 */
record SavedFiles(Set<Path> files) {
    SavedFiles {
        files = Set.copyOf(files);
    }

    boolean isNothing() {
        return files.isEmpty();
    }
}
