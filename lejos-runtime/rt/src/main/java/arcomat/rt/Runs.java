package arcomat.rt;

/**
 * Runs of a requirement: where each is, what is to be seen on each output, and what in the model
 * says so. Kept field by field, so that to follow them makes no objects.
 */
final class Runs {
    private static final int FIRST = 4;

    /** Instead of the state in which no transition was enabled: a transition was taken. */
    static final int TAKEN = -2;

    private final int width;
    private int size;

    /** The transition, or the kind of completion. */
    private String[] causes = new String[FIRST];

    /** Where no transition was enabled. */
    private int[] origins = new int[FIRST];

    private int[] states = new int[FIRST];
    private final Values variables = new Values();
    private final Messages promises;

    /** By hash: one more than the number of a run, or 0. */
    private int[] index = new int[2 * FIRST];

    /**
     * @param width number of variables
     * @param ports number of outputs
     */
    Runs(int width, int ports) {
        this.width = width;
        this.promises = new Messages(ports);
    }

    int size() {
        return size;
    }

    int state(int run) {
        return states[run];
    }

    String cause(int run) {
        return causes[run];
    }

    int origin(int run) {
        return origins[run];
    }

    Messages promises() {
        return promises;
    }

    long number(int run, int variable) {
        return variables.number(run * width + variable);
    }

    Object object(int run, int variable) {
        return variables.object(run * width + variable);
    }

    void clear() {
        size = 0;
        variables.cut(0);
        promises.clear();
    }

    /** A further run that promises silence, with variables that are to be set. */
    void add(String cause, int origin, int state) {
        row(cause, origin, state);
        for (int i = 0; i < width; i++) {
            variables.add(0);
        }
        promises.add();
    }

    /** A further run that promises silence, with the variables of another one. */
    void add(String cause, int origin, int state, Runs from, int run) {
        row(cause, origin, state);
        copy(from, run);
        promises.add();
    }

    /** A further run that promises what another one does. */
    void addSame(String cause, int origin, Runs from, int run) {
        row(cause, origin, from.states[run]);
        copy(from, run);
        promises.add(from.promises, run);
    }

    private void copy(Runs from, int run) {
        for (int i = 0; i < width; i++) {
            variables.add(from.variables, run * width + i);
        }
    }

    private void row(String cause, int origin, int state) {
        grow();
        causes[size] = cause;
        origins[size] = origin;
        states[size] = state;
        size++;
    }

    private void grow() {
        if (size == states.length) {
            String[] texts = new String[2 * size];
            System.arraycopy(causes, 0, texts, 0, size);
            causes = texts;
            origins = Values.longer(origins);
            states = Values.longer(states);
        }
    }

    /** A variable of the last run. */
    void set(int variable, long number) {
        variables.set((size - 1) * width + variable, number);
    }

    void set(int variable, Object object) {
        variables.set((size - 1) * width + variable, object);
    }

    /** Forgets all but the first runs. */
    void cut(int first) {
        size = first;
        variables.cut(first * width);
        promises.cut(first);
    }

    /** Forgets all but one. */
    void keepOnly(int run) {
        move(run, 0);
        cut(1);
    }

    private void move(int from, int to) {
        if (from != to) {
            causes[to] = causes[from];
            origins[to] = origins[from];
            states[to] = states[from];
            variables.move(from * width, to * width, width);
            promises.move(from, to);
        }
    }

    /**
     * Keeps the runs whose promises agree with what is seen; all of them if none does.
     *
     * @param delayed per port
     * @param late whether the ports with a delay are to be looked at, or those without
     * @return whether any does
     */
    boolean keep(Messages seen, boolean[] delayed, boolean late) {
        int kept = 0;
        for (int run = 0; run < size; run++) {
            if (agrees(run, seen, delayed, late)) {
                move(run, kept);
                kept++;
            }
        }
        if (kept > 0) {
            cut(kept);
        }
        return kept > 0;
    }

    private boolean agrees(int run, Messages seen, boolean[] delayed, boolean late) {
        for (int port = 0; port < delayed.length; port++) {
            if (delayed[port] == late && !promises.allows(run, port, seen)) {
                return false;
            }
        }
        return true;
    }

    /** Runs that are at the same place are one run; promises that have been kept do not matter. */
    void merge() {
        int length = prepareIndex();
        int kept = 0;
        for (int run = 0; run < size; run++) {
            int slot = slot(run, length - 1);
            if (index[slot] == 0) {
                move(run, kept);
                kept++;
                index[slot] = kept;
            }
        }
        cut(kept);
    }

    /** As much of the index as is needed for half of it to stay empty. */
    private int prepareIndex() {
        int length = 2 * FIRST;
        while (length < 2 * size) {
            length *= 2;
        }
        growIndex(length);
        for (int i = 0; i < length; i++) {
            index[i] = 0;
        }
        return length;
    }

    private void growIndex(int length) {
        if (index.length < length) {
            index = new int[length];
        }
    }

    /** Where a run is, or would be. */
    private int slot(int run, int mask) {
        int slot = hash(run) & mask;
        while (index[slot] != 0 && !isSame(index[slot] - 1, run)) {
            slot = slot + 1 & mask;
        }
        return slot;
    }

    private int hash(int run) {
        int hash = states[run];
        for (int i = 0; i < width && states[run] != Monitor.CHAOS; i++) {
            hash = 31 * hash + variables.hash(run * width + i);
        }
        return hash ^ hash >>> 16 ^ hash >>> 8;
    }

    private boolean isSame(int one, int other) {
        boolean same = states[one] == states[other];
        for (int i = 0; same && i < width && states[one] != Monitor.CHAOS; i++) {
            same = variables.same(one * width + i, variables, other * width + i);
        }
        return same;
    }

    /** A run in chaos, or -1. */
    int chaos() {
        for (int run = 0; run < size; run++) {
            if (states[run] == Monitor.CHAOS) {
                return run;
            }
        }
        return -1;
    }
}
