package nxt.actuators;

import arcomat.nxt.Link;
import arcomat.nxt.Mailbox;

/** Platform component nxt.BluetoothOut<Boolean> on the brick. */
public final class BluetoothOutOfBoolean {
    public boolean sent;

    public boolean hasSent;

    private final Mailbox out;

    public BluetoothOutOfBoolean(String peer, int channel) {
        out = Link.to(peer).outgoing(channel);
    }

    /** Hands over the message of a slice; the link sends it. */
    public void act() {
        if (hasSent) {
            out.put(sent ? 1 : 0);
        }
    }
}
