package nxt.sensors;

import arcomat.nxt.Link;
import arcomat.nxt.Mailbox;

/** Platform component nxt.BluetoothIn<Boolean> on the brick. */
public final class BluetoothInOfBoolean {
    public boolean received;

    public boolean hasReceived;

    private final Mailbox in;

    public BluetoothInOfBoolean(String peer, int channel) {
        in = Link.to(peer).incoming(channel);
    }

    /** Takes a message that has arrived: the start of a slice. */
    public void sense() {
        hasReceived = !in.isEmpty();
        if (hasReceived) {
            received = in.take() != 0;
        }
    }
}
