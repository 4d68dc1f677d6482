package arcomat.cli.terminal;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Standard output, which remembers why something was lost. Nothing is lost where a reader has had
 * enough, as {@code head} has.
 */
final class ResultStream extends FilterOutputStream {
    private static final int FILE_TYPE = 0170000;
    private static final int PIPE = 0010000;
    private static final int SOCKET = 0140000;

    private Optional<String> loss = Optional.empty();

    private ResultStream(OutputStream target) {
        super(target);
    }

    /** That of the process. System.out would keep failures to itself. */
    static ResultStream ofProcess() {
        return new ResultStream(new FileOutputStream(FileDescriptor.out));
    }

    /** Why not all of it could be written. */
    Optional<String> loss() {
        return loss;
    }

    @Override
    public void write(int b) throws IOException {
        write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int from, int length) throws IOException {
        try {
            out.write(bytes, from, length);
        } catch (IOException e) {
            if (loss.isEmpty() && !isReaderGone(e)) {
                loss = Optional.of(String.valueOf(e.getMessage()));
            }
            throw e;
        }
    }

    /** The message alone would not do: it is in the language of the machine. */
    private static boolean isReaderGone(IOException e) {
        if ("Broken pipe".equals(e.getMessage())) {
            return true;
        }
        try {
            Object mode = Files.getAttribute(Path.of("/dev/fd/1"), "unix:mode");
            int type = (Integer) mode & FILE_TYPE;
            return type == PIPE || type == SOCKET;
        } catch (IOException | RuntimeException notUnix) {
            return false;
        }
    }
}
