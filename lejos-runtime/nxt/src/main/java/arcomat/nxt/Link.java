package arcomat.nxt;

import lejos.nxt.comm.Bluetooth;
import lejos.nxt.comm.NXTConnection;
import lejos.util.Delay;

/**
 * The connection to another brick. Calling, waiting to be called and sending take long, so a thread
 * does them; the program only looks into mailboxes. A connection that breaks is made anew.
 *
 * <p>A packet is one message: its channel and its four bytes, the highest first.
 */
public final class Link extends Thread {
    private static final int CHANNELS = 8;
    private static final int PACKET = 5;

    /** What a connection is to tell of a packet that arrives: its length, here or not. */
    private static final int WHOLE_PACKET = 2;

    /** How long to wait for a call before looking again, in milliseconds. */
    private static final int PATIENCE = 10000;

    /** From a call that failed to the next, in milliseconds. */
    private static final int PAUSE = 1000;

    /** From one look for messages to the next, in milliseconds. */
    private static final int REST = 10;

    /** Ports with the same peer share one link; the links are chained. */
    private static Link first;

    private final Link following;
    private final String peer;
    private final Mailbox[] incoming = new Mailbox[CHANNELS];
    private final Mailbox[] outgoing = new Mailbox[CHANNELS];
    private final byte[] packet = new byte[PACKET];

    private Link(String peer, Link following) {
        this.peer = peer;
        this.following = following;
    }

    /**
     * The link to a brick.
     *
     * @param peer its name; empty for the one that calls this brick
     */
    public static Link to(String peer) {
        for (Link link = first; link != null; link = link.following) {
            if (link.peer.equals(peer)) {
                return link;
            }
        }
        first = new Link(peer, first);
        // The program may end while it is connected.
        first.setDaemon(true);
        first.start();
        return first;
    }

    /** What arrives on a channel, 0 to 7. */
    public synchronized Mailbox incoming(int channel) {
        return box(incoming, channel);
    }

    /** What is to be sent on a channel, 0 to 7. */
    public synchronized Mailbox outgoing(int channel) {
        return box(outgoing, channel);
    }

    private static Mailbox box(Mailbox[] boxes, int channel) {
        if (boxes[channel] == null) {
            boxes[channel] = new Mailbox();
        }
        return boxes[channel];
    }

    public void run() {
        while (true) {
            NXTConnection connection = connect();
            if (connection == null) {
                Delay.msDelay(PAUSE);
            } else {
                while (receive(connection) && send(connection)) {
                    Delay.msDelay(REST);
                }
                connection.close();
            }
        }
    }

    /** Null where nobody answers or calls. */
    private NXTConnection connect() {
        return peer.length() == 0
                ? Bluetooth.waitForConnection(PATIENCE, NXTConnection.PACKET)
                : Bluetooth.connect(peer, NXTConnection.PACKET);
    }

    /**
     * Takes what has arrived; false if the connection is broken. A packet may arrive in parts: once
     * it has begun, this waits some milliseconds for the rest.
     */
    private boolean receive(NXTConnection connection) {
        int length = connection.available(WHOLE_PACKET);
        while (length > 0) {
            int taken = connection.read(packet, PACKET, true);
            // A packet of another program is no message.
            if (length == PACKET && taken == PACKET && packet[0] >= 0 && packet[0] < CHANNELS) {
                incoming(packet[0]).put(message());
            }
            if (taken < 0 || !skip(connection, length - taken)) {
                return false;
            }
            length = connection.available(WHOLE_PACKET);
        }
        // Reads nothing, but says whether the connection stands.
        return connection.read(packet, 0, false) == 0;
    }

    /** Leaves out the rest of a packet that is too long; false if the connection is broken. */
    private boolean skip(NXTConnection connection, int rest) {
        while (rest > 0) {
            int taken = connection.read(packet, Math.min(rest, PACKET), true);
            if (taken <= 0) {
                return false;
            }
            rest -= taken;
        }
        return true;
    }

    private int message() {
        int message = 0;
        for (int i = 1; i < PACKET; i++) {
            message = message << 8 | packet[i] & 0xFF;
        }
        return message;
    }

    /** Sends what waits; false if the connection is broken. */
    private boolean send(NXTConnection connection) {
        for (int channel = 0; channel < CHANNELS; channel++) {
            Mailbox box = outgoing(channel);
            while (!box.isEmpty()) {
                pack(channel, box.take());
                if (connection.write(packet, PACKET, true) != PACKET) {
                    return false;
                }
            }
        }
        return true;
    }

    private void pack(int channel, int message) {
        packet[0] = (byte) channel;
        for (int i = PACKET - 1; i > 0; i--) {
            packet[i] = (byte) message;
            message >>= 8;
        }
    }
}
