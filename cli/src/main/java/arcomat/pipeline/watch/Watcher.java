package arcomat.pipeline.watch;

import java.io.IOException;

/** Waits for changes of the files that are watched. */
interface Watcher extends AutoCloseable {
    /** What happened until it is quiet again; waits for it. */
    SavedFiles await() throws InterruptedException, IOException;

    @Override
    void close() throws IOException;
}
