package arcomat.analysis.search.packed;

import arcomat.analysis.search.IntKey;
import arcomat.analysis.search.Numbering;

import com.carrotsearch.hppc.LongIntHashMap;

import java.util.Arrays;

/**
 * What some latched ports of a part hold, all together as one number: 0 where they hold nothing.
 */
final class HeldMessages {
    /** In place of a message, where a port holds none. */
    static final int NONE = -1;

    private final int ports;
    private final Runnable compute;
    private final Numbering<IntKey> met = new Numbering<>();
    private final LongIntHashMap after = new LongIntHashMap();

    /**
     * @param compute called before something new gets a number
     */
    HeldMessages(int ports, Runnable compute) {
        this.ports = ports;
        this.compute = compute;
        int[] nothing = new int[ports];
        Arrays.fill(nothing, NONE);
        met.number(new IntKey(nothing));
    }

    /** How many ports there are. */
    int ports() {
        return ports;
    }

    /** How many such numbers have been met. */
    int size() {
        return met.size();
    }

    /**
     * @param messages by port the number of a message, or {@link #NONE}; taken over
     */
    int number(int[] messages) {
        return met.number(new IntKey(messages));
    }

    /** The message on a port, or {@link #NONE}. */
    int message(int held, int port) {
        return met.get(held).all()[port];
    }

    /** What they hold after one of them got a message. */
    int after(int held, int port, int message) {
        if (message >>> 16 != 0 || port >>> 15 != 0) {
            throw new PackedNetwork.CannotPack("too many messages are held");
        }
        long key = (long) held << 32 | (long) port << 16 | message;
        int slot = after.indexOf(key);
        if (after.indexExists(slot)) {
            return after.indexGet(slot);
        }
        compute.run();
        int[] changed = met.get(held).all().clone();
        changed[port] = message;
        int number = number(changed);
        after.indexInsert(slot, key, number);
        return number;
    }
}
