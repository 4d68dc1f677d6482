package nxt.actuators;

import arcomat.nxt.Link;
import arcomat.nxt.Mailbox;

/** Platform component nxt.BluetoothOut on the brick, for messages of an enum. */
public class BluetoothOut {
    private static final int SILENCE = 0;

    /** The code of a constant; 0 for no message. */
    public int sent;

    private final Mailbox out;

    public BluetoothOut(String peer, int channel) {
        out = Link.to(peer).outgoing(channel);
    }

    /** Hands over the message of a slice; the link sends it. */
    public void act() {
        if (sent != SILENCE) {
            out.put(sent);
        }
    }
}
