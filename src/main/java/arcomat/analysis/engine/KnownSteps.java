package arcomat.analysis.engine;

import arcomat.model.Trace;

import com.carrotsearch.hppc.LongObjectHashMap;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** The steps out of one configuration by the kind of the letter; equal steps are kept once. */
final class KnownSteps {
    private final LongObjectHashMap<Steps> byKind = new LongObjectHashMap<>(2);
    private final List<Steps> distinct = new ArrayList<>(2);

    /** Null where they are not known yet. */
    Steps find(long kind) {
        return byKind.get(kind);
    }

    /** Returns what is kept. */
    Steps add(long kind, Steps computed) {
        Steps kept = computed;
        for (Steps each : distinct) {
            if (each.isSame(computed)) {
                kept = each;
                break;
            }
        }
        if (kept == computed) {
            distinct.add(kept);
        }
        byKind.put(kind, kept);
        return kept;
    }

    void collectUsed(Set<Trace.Cause> found) {
        distinct.forEach(steps -> steps.collectUsed(found));
    }
}
