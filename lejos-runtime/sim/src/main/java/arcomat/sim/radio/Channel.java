package arcomat.sim.radio;

/**
 * Packets on their way in one direction, in order. Fixed room, as on the brick: a sender must wait
 * when it is full; sending and receiving allocate nothing.
 */
public final class Channel {
    /** Microseconds on the air, as measured between two NXT: a few hundredths of a second. */
    static final long LATENCY = 30_000;

    /** Microseconds between the parts of a packet that arrives in two, as seen on the brick. */
    static final long PAUSE = 8_000;

    /** One packet of so many comes in two parts. */
    private static final int BROKEN = 4;

    private static final int PACKETS = 64;
    private static final int LONGEST = 254;

    private final boolean inPieces;
    private final byte[][] packets = new byte[PACKETS][LONGEST];
    private final int[] lengths = new int[PACKETS];

    /** How much of a packet arrives first. */
    private final int[] firstParts = new int[PACKETS];

    private final long[] arrivals = new long[PACKETS];
    private int sent;
    private int first;
    private int count;
    private int consumed;
    private boolean closed;

    /**
     * @param inPieces whether some packets arrive in two parts
     */
    Channel(boolean inPieces) {
        this.inPieces = inPieces;
    }

    /** The most bytes that one packet takes. */
    public int longest() {
        return LONGEST;
    }

    /**
     * Sends a packet; false if there is no room at the moment.
     *
     * @param length at least 1
     */
    public boolean send(byte[] data, int length, long now) {
        if (count == PACKETS) {
            return false;
        }
        int slot = (first + count) % PACKETS;
        System.arraycopy(data, 0, packets[slot], 0, length);
        lengths[slot] = length;
        firstParts[slot] = firstPart(length);
        arrivals[slot] = now + LATENCY;
        count++;
        sent++;
        return true;
    }

    /** Which packets break, and where, is as good as chance, and the same in every run. */
    private int firstPart(int length) {
        boolean breaks = inPieces && length > 1 && sent % BROKEN == BROKEN - 1;
        return breaks ? 1 + sent / BROKEN % (length - 1) : length;
    }

    /** The packet of which at least the beginning has arrived. */
    private boolean hasBegun(long now) {
        return count > 0 && arrivals[first] <= now;
    }

    /** Bytes of the packet whose beginning has arrived; 0 if there is none. */
    public int length(long now) {
        return hasBegun(now) ? lengths[first] : 0;
    }

    /** Bytes of that packet that have not been taken, here or not; 0 if there is none. */
    public int left(long now) {
        return hasBegun(now) ? lengths[first] - consumed : 0;
    }

    /** Bytes of that packet that can be taken now. */
    public int arrived(long now) {
        if (!hasBegun(now)) {
            return 0;
        }
        boolean whole = arrivals[first] + PAUSE <= now;
        return (whole ? lengths[first] : firstParts[first]) - consumed;
    }

    /**
     * Takes bytes that have arrived. The packet leaves with its last byte.
     *
     * @param length at most as many as have arrived
     */
    public void take(byte[] buffer, int length) {
        System.arraycopy(packets[first], consumed, buffer, 0, length);
        consumed += length;
        if (consumed == lengths[first]) {
            first = (first + 1) % PACKETS;
            count--;
            consumed = 0;
        }
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
