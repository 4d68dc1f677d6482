package arcomat.analysis.search.packed;

import arcomat.semantics.expression.Sent;

import com.carrotsearch.hppc.IntArrayList;
import com.carrotsearch.hppc.LongIntHashMap;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * What compared outputs show within a step, one message after the other, in numbers: a tree, in
 * which a sequence is the one before its last message, and that message. 0 is the empty one.
 */
final class ShownSequences {
    private record Shown(int signal, Sent sent) {}

    private final List<Shown> things = new ArrayList<>();
    private final IntArrayList before = new IntArrayList();
    private final IntArrayList last = new IntArrayList();
    private final LongIntHashMap longer = new LongIntHashMap();

    ShownSequences() {
        before.add(0);
        last.add(0);
    }

    /** A new number for a message on a signal. */
    int thing(int signal, Sent sent) {
        things.add(new Shown(signal, sent));
        return things.size() - 1;
    }

    /** A sequence with one thing more. */
    int then(int sequence, int thing) {
        long key = (long) sequence << 32 | thing;
        int slot = longer.indexOf(key);
        if (longer.indexExists(slot)) {
            return longer.indexGet(slot);
        }
        int number = before.size();
        before.add(sequence);
        last.add(thing);
        longer.put(key, number);
        return number;
    }

    /** What a sequence has on a signal, in order. */
    List<Sent> on(int signal, int sequence) {
        List<Sent> sent = new ArrayList<>();
        for (int each = sequence; each != 0; each = before.get(each)) {
            Shown shown = things.get(last.get(each));
            if (shown.signal == signal) {
                sent.add(shown.sent);
            }
        }
        Collections.reverse(sent);
        return sent;
    }
}
