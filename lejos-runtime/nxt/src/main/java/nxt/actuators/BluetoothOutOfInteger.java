package nxt.actuators;

import arcomat.nxt.Link;
import arcomat.nxt.Mailbox;

/** Platform component nxt.BluetoothOut<Integer> on the brick. */
public final class BluetoothOutOfInteger {
    public int sent;

    public boolean hasSent;

    private final Mailbox out;

    public BluetoothOutOfInteger(String peer, int channel) {
        out = Link.to(peer).outgoing(channel);
    }

    /** Hands over the message of a slice; the link sends it. */
    public void act() {
        if (hasSent) {
            out.put(sent);
        }
    }
}
