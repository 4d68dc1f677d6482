package lejos.nxt.comm;

import java.io.IOException;
import java.io.InputStream;

/** What comes over a connection, as bytes. Reading waits. */
public class NXTInputStream extends InputStream {
    private final NXTConnection connection;
    private final byte[] single = new byte[1];

    NXTInputStream(NXTConnection connection) {
        this.connection = connection;
    }

    @Override
    public int read() throws IOException {
        return read(single, 0, 1) < 0 ? -1 : single[0] & 0xff;
    }

    @Override
    public int read(byte[] b, int off, int len) throws IOException {
        if (len == 0) {
            return 0;
        }
        byte[] part = off == 0 ? b : new byte[len];
        int taken = connection.readBytes(part, len);
        if (part != b && taken > 0) {
            System.arraycopy(part, 0, b, off, taken);
        }
        return taken;
    }

    @Override
    public int available() throws IOException {
        return connection.available();
    }

    @Override
    public void close() {
        // The connection stays: on the brick, too, it is closed by its own method.
    }
}
