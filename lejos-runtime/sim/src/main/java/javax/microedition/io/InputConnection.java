package javax.microedition.io;

import java.io.DataInputStream;
import java.io.InputStream;

/** A connection with a stream of bytes. */
public interface InputConnection extends Connection {
    InputStream openInputStream();

    DataInputStream openDataInputStream();
}
