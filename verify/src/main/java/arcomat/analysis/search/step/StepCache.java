package arcomat.analysis.search.step;

import arcomat.model.Trace;

import com.carrotsearch.hppc.LongObjectHashMap;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The steps out of one configuration by the kind of the letter; equal steps are kept once. */
public final class StepCache {
    /** From so many on, it takes a hash table to find equal ones soon. */
    private static final int MANY = 8;

    private final LongObjectHashMap<Steps> byKind = new LongObjectHashMap<>(2);
    private final List<Steps> distinct = new ArrayList<>(2);
    private @Nullable Map<List<Object>, Steps> byContent;

    /** Null where they are not known yet. */
    public @Nullable Steps find(long kind) {
        return byKind.get(kind);
    }

    /** Returns what is kept. */
    public Steps add(long kind, Steps computed) {
        Steps kept = distinct.size() < MANY ? sameAs(computed) : byContent(computed);
        if (kept == computed) {
            distinct.add(kept);
        }
        byKind.put(kind, kept);
        return kept;
    }

    private Steps sameAs(Steps computed) {
        for (Steps each : distinct) {
            if (each.isSame(computed)) {
                return each;
            }
        }
        return computed;
    }

    private Steps byContent(Steps computed) {
        if (byContent == null) {
            byContent = new HashMap<>();
            for (Steps each : distinct) {
                byContent.put(each.content(), each);
            }
        }
        Steps known = byContent.putIfAbsent(computed.content(), computed);
        return known == null ? computed : known;
    }

    public void collectUsed(Set<Trace.Cause> found) {
        distinct.forEach(steps -> steps.collectUsed(found));
    }
}
