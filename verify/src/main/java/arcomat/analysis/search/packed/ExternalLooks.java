package arcomat.analysis.search.packed;

import arcomat.analysis.search.Numbering;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import com.carrotsearch.hppc.LongIntHashMap;

import java.util.ArrayList;
import java.util.List;

/** How inputs from outside are looked at, all together as one number. */
final class ExternalLooks {
    private final Numbering<List<PortAbstraction>> met = new Numbering<>();
    private final LongIntHashMap joined = new LongIntHashMap();

    /**
     * @param looks by external input
     */
    int number(List<PortAbstraction> looks) {
        return met.number(List.copyOf(looks));
    }

    List<PortAbstraction> get(int number) {
        return met.get(number);
    }

    /** What looks as closely as both. */
    int join(int one, int other) {
        long key = (long) one << 32 | other;
        int slot = joined.indexOf(key);
        if (joined.indexExists(slot)) {
            return joined.indexGet(slot);
        }
        List<PortAbstraction> looks = new ArrayList<>();
        for (int input = 0; input < met.get(one).size(); input++) {
            looks.add(met.get(one).get(input).and(met.get(other).get(input)));
        }
        int number = number(looks);
        joined.indexInsert(slot, key, number);
        return number;
    }
}
