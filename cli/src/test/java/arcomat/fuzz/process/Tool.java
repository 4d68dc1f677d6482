package arcomat.fuzz.process;

import java.io.IOException;

/** The installed tool, in one way of starting it. */
interface Tool extends AutoCloseable {
    /** What a busy machine takes for what a quiet one does in ten seconds. */
    int PATIENCE_SECONDS = 90;

    Outcome run(Sandbox sandbox, Call call) throws IOException, InterruptedException;

    @Override
    void close() throws IOException;
}
