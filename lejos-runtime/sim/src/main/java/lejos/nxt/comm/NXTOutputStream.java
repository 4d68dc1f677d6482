package lejos.nxt.comm;

import java.io.IOException;
import java.io.OutputStream;

/** Bytes for a connection, collected until they are flushed or make a packet. */
public class NXTOutputStream extends OutputStream {
    private static final int CAPACITY = 254;

    private final NXTConnection connection;
    private final byte[] buffer = new byte[CAPACITY];
    private int length;

    NXTOutputStream(NXTConnection connection) {
        this.connection = connection;
    }

    @Override
    public void write(int b) throws IOException {
        if (length == CAPACITY) {
            flush();
        }
        buffer[length++] = (byte) b;
    }

    @Override
    public void flush() throws IOException {
        if (length > 0 && connection.write(buffer, length) < 0) {
            throw new IOException("the connection is closed");
        }
        length = 0;
    }

    @Override
    public void close() throws IOException {
        flush();
    }
}
