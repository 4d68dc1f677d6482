package arcomat.sim.radio;

/**
 * Packets on their way in one direction, in order. Fixed room, as on the brick: a sender must wait
 * when it is full; sending and receiving allocate nothing.
 */
public final class Channel {
    /** Microseconds on the air, as measured between two NXT: a few hundredths of a second. */
    static final long LATENCY = 30_000;

    private static final int PACKETS = 64;
    private static final int LONGEST = 254;

    private final byte[][] packets = new byte[PACKETS][LONGEST];
    private final int[] lengths = new int[PACKETS];
    private final long[] arrivals = new long[PACKETS];
    private int first;
    private int count;
    private int consumed;
    private boolean closed;

    /** The most bytes that one packet takes. */
    public int longest() {
        return LONGEST;
    }

    /** Sends a packet; false if there is no room at the moment. */
    public boolean send(byte[] data, int length, long now) {
        if (count == PACKETS) {
            return false;
        }
        int slot = (first + count) % PACKETS;
        System.arraycopy(data, 0, packets[slot], 0, length);
        lengths[slot] = length;
        arrivals[slot] = now + LATENCY;
        count++;
        return true;
    }

    /** Bytes left in the packet that has arrived; -1 if none has. */
    public int arrived(long now) {
        return count > 0 && arrivals[first] <= now ? lengths[first] - consumed : -1;
    }

    /** Takes bytes of the packet that has arrived; the packet leaves with its last byte. */
    public int take(byte[] buffer, int offset, int length) {
        int taken = Math.min(length, lengths[first] - consumed);
        System.arraycopy(packets[first], consumed, buffer, offset, taken);
        consumed += taken;
        if (consumed == lengths[first]) {
            drop();
        }
        return taken;
    }

    /** Forgets what is left of the packet that has arrived. */
    public void drop() {
        first = (first + 1) % PACKETS;
        count--;
        consumed = 0;
    }

    public void close() {
        closed = true;
    }

    /** Nothing comes any more, now or later. */
    public boolean isFinished() {
        return closed && count == 0;
    }

    public boolean isClosed() {
        return closed;
    }
}
