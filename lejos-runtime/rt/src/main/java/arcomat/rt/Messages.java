package arcomat.rt;

/**
 * What is promised about the outputs, or seen on them: rows with an entry for each port, which is
 * no message, some messages, or something that is left open.
 */
final class Messages {
    /** Instead of a number of messages: one message, whichever. */
    static final int ANY_MESSAGE = -1;

    /** Instead of a number of messages: messages or none. */
    static final int ANYTHING = -2;

    private final int ports;

    /** How many messages each entry has. */
    private int[] counts;

    /** Where they begin. */
    private int[] starts;

    private final Values messages = new Values();
    private int rows;

    Messages(int ports) {
        this.ports = ports;
        this.counts = row();
        this.starts = row();
    }

    /** Makes an array; in a method, whose size the prediction of memory knows by its name. */
    private int[] row() {
        return new int[ports];
    }

    void clear() {
        rows = 0;
        messages.cut(0);
    }

    /** A further row, without any message. */
    void add() {
        int first = rows * ports;
        grow(first + ports);
        for (int i = first; i < first + ports; i++) {
            counts[i] = 0;
        }
        rows++;
    }

    private void grow(int size) {
        if (size > counts.length) {
            counts = Values.longer(counts);
            starts = Values.longer(starts);
        }
    }

    /** A further row, with what a row elsewhere has. */
    void add(Messages from, int row) {
        add();
        for (int port = 0; port < ports; port++) {
            int there = row * ports + port;
            int here = (rows - 1) * ports + port;
            counts[here] = from.counts[there];
            starts[here] = messages.size();
            for (int i = 0; i < from.counts[there]; i++) {
                messages.add(from.messages, from.starts[there] + i);
            }
        }
    }

    /** Leaves a port of the last row open. */
    void open(int port, int kind) {
        counts[(rows - 1) * ports + port] = kind;
    }

    /** One message more on a port of the last row; those of a port follow each other. */
    void send(int port, long message) {
        count(port);
        messages.add(message);
    }

    void send(int port, Object message) {
        count(port);
        messages.add(message);
    }

    void send(int port, Values from, int index) {
        count(port);
        messages.add(from, index);
    }

    private void count(int port) {
        int entry = (rows - 1) * ports + port;
        if (counts[entry] == 0) {
            starts[entry] = messages.size();
        }
        counts[entry]++;
    }

    void move(int from, int to) {
        for (int port = 0; port < ports; port++) {
            counts[to * ports + port] = counts[from * ports + port];
            starts[to * ports + port] = starts[from * ports + port];
        }
    }

    /** Forgets all rows but the first. */
    void cut(int first) {
        rows = first;
    }

    /** How many messages, or how it is left open. */
    int count(int row, int port) {
        return counts[row * ports + port];
    }

    /** All messages, and perhaps some that are no row's any more. */
    Values values() {
        return messages;
    }

    /** The place of the first message among the values. */
    int start(int row, int port) {
        return starts[row * ports + port];
    }

    /** Whether the promise of a row is kept by the only row of what is seen. */
    boolean allows(int row, int port, Messages seen) {
        int promised = count(row, port);
        int shown = seen.count(0, port);
        if (promised < 0) {
            return promised == ANYTHING || shown == 1;
        }
        boolean same = promised == shown;
        for (int i = 0; same && i < promised; i++) {
            same = messages.same(start(row, port) + i, seen.messages, seen.start(0, port) + i);
        }
        return same;
    }
}
