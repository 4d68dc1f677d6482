package arcomat.nxt;

/**
 * Messages between the program and a thread of the Bluetooth. It holds a few; where more come, the
 * oldest are lost: nobody waits for room.
 */
public final class Mailbox {
    private static final int CAPACITY = 8;

    private final int[] messages = new int[CAPACITY];
    private int oldest;
    private int count;

    public synchronized void put(int message) {
        if (count == CAPACITY) {
            oldest = (oldest + 1) % CAPACITY;
            count--;
        }
        messages[(oldest + count++) % CAPACITY] = message;
    }

    public synchronized boolean isEmpty() {
        return count == 0;
    }

    /**
     * The oldest message. There is one, where only the caller takes them and none is lost
     * meanwhile.
     */
    public synchronized int take() {
        int message = messages[oldest];
        oldest = (oldest + 1) % CAPACITY;
        count--;
        return message;
    }
}
