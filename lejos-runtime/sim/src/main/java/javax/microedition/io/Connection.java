package javax.microedition.io;

import java.io.IOException;

/** Something that can be closed. */
public interface Connection {
    void close() throws IOException;
}
