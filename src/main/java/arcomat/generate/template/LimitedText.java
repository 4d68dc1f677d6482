package arcomat.generate.template;

import java.io.IOException;
import java.io.Writer;

/** The text of one file, of which a loop without an end would fill the memory. */
final class LimitedText extends Writer {
    /** Characters; far more than a compiler takes. */
    private static final int MOST = 1 << 26;

    private final StringBuilder text = new StringBuilder();

    @Override
    public void write(char[] characters, int from, int length) throws IOException {
        require(length);
        text.append(characters, from, length);
    }

    @Override
    public void write(String piece, int from, int length) throws IOException {
        require(length);
        text.append(piece, from, from + length);
    }

    private void require(int room) throws IOException {
        if (room > MOST - text.length()) {
            throw new IOException(
                    "it writes more than "
                            + (MOST >> 20)
                            + " million characters; does each of its loops have an end?");
        }
    }

    @Override
    public void flush() {}

    @Override
    public void close() {}

    @Override
    public String toString() {
        return text.toString();
    }
}
