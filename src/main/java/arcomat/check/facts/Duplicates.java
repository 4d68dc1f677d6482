package arcomat.check.facts;

import arcomat.check.law.Check.Findings;
import arcomat.tree.Name;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Function;

/** Things that should differ in something, most of them in name. */
public final class Duplicates {
    private Duplicates() {}

    /**
     * Tells of each thing that has the key of an earlier one.
     *
     * @param report gets the thing, and the first one of its key
     */
    public static <T> void report(
            List<? extends T> things, Function<? super T, ?> key, BiConsumer<T, T> report) {
        if (things.size() < 2) {
            return;
        }
        Map<Object, T> seen = new HashMap<>();
        for (T thing : things) {
            T first = seen.putIfAbsent(key.apply(thing), thing);
            if (first != null) {
                report.accept(thing, first);
            }
        }
    }

    /**
     * Reports each name that an earlier one has.
     *
     * @param message with {@code %s} for the owner, and for the name
     * @param owner the name of what the names have to differ in
     * @param note about the earlier one
     */
    public static void report(
            List<Name> names, Findings findings, String message, Object owner, String note) {
        report(
                names,
                (name, first) -> findings.report(name, message, owner, name).related(first, note));
    }

    /** As above, of names that stand for what has them. */
    public static void report(List<Name> names, BiConsumer<Name, Name> report) {
        report(names, Name::text, report);
    }
}
