package arcomat.agent.server;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** Lines that anybody may have written: one without an end would fill the memory. */
final class LineReader {
    /** Bytes. */
    static final int LONGEST = 1 << 20;

    private final InputStream in;

    LineReader(InputStream in) {
        this.in = new BufferedInputStream(in);
    }

    /**
     * A line.
     *
     * @param text without its end; empty where it is too long
     */
    record Line(String text, boolean tooLong) {}

    /** The next line; empty at the end. */
    Optional<Line> next() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        boolean tooLong = false;
        int read = in.read();
        if (read < 0) {
            return Optional.empty();
        }
        while (read >= 0 && read != '\n') {
            tooLong |= bytes.size() == LONGEST;
            if (!tooLong) {
                bytes.write(read);
            }
            read = in.read();
        }
        String text = tooLong ? "" : bytes.toString(StandardCharsets.UTF_8).strip();
        return Optional.of(new Line(text, tooLong));
    }
}
