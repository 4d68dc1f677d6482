package nxt.sensors;

import arcomat.nxt.Link;
import arcomat.nxt.Mailbox;

/** Platform component nxt.BluetoothIn<Integer> on the brick. */
public final class BluetoothInOfInteger {
    public int received;

    public boolean hasReceived;

    private final Mailbox in;

    public BluetoothInOfInteger(String peer, int channel) {
        in = Link.to(peer).incoming(channel);
    }

    /** Takes a message that has arrived: the start of a slice. */
    public void sense() {
        hasReceived = !in.isEmpty();
        if (hasReceived) {
            received = in.take();
        }
    }
}
