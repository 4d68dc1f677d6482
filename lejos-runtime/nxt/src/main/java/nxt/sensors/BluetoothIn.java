package nxt.sensors;

import arcomat.nxt.Link;
import arcomat.nxt.Mailbox;

/** Platform component nxt.BluetoothIn on the brick, for messages of an enum. */
public class BluetoothIn {
    private static final int SILENCE = 0;

    /** The code of a constant; 0 for no message. */
    public int received;

    private final Mailbox in;

    public BluetoothIn(String peer, int channel) {
        in = Link.to(peer).incoming(channel);
    }

    /** Takes a message that has arrived: the start of a slice. */
    public void sense() {
        received = in.isEmpty() ? SILENCE : in.take();
    }
}
