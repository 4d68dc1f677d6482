package javax.microedition.io;

import java.io.DataOutputStream;
import java.io.OutputStream;

/** A connection with a stream of bytes. */
public interface OutputConnection extends Connection {
    OutputStream openOutputStream();

    DataOutputStream openDataOutputStream();
}
