package arcomat.analysis.coupling;

import arcomat.analysis.bits.BitLetters;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** One question about a slice: whether there are messages and variables for something. */
final class SliceSolver {
    private static final int LESSONS = 20;

    private final BitLetters letters;
    private final List<Port> observed;

    /**
     * @param before what is known of variables
     * @param stop asked now and then, whether to give up
     */
    SliceSolver(Slice slice, List<Comparison> before, List<Port> observed, BooleanSupplier stop) {
        this.observed = observed;
        letters = new BitLetters(slice.ports(), same(before), LESSONS, stop);
        before.forEach(each -> claim(truth(each.claim())));
    }

    /** Of variables that have the same value all but one, each with that one. */
    private static Map<Port, Port> same(List<Comparison> before) {
        Map<Port, Port> first = new LinkedHashMap<>();
        for (Comparison each : before) {
            each.same().ifPresent(other -> join(each.variable(), other, first));
        }
        return first;
    }

    private static void join(Port variable, Port other, Map<Port, Port> first) {
        Port one = first.getOrDefault(variable, variable);
        Port two = first.getOrDefault(other, other);
        if (!one.equals(two)) {
            first.replaceAll(
                    (port, representative) -> representative.equals(two) ? one : representative);
            first.put(two, one);
        }
    }

    void claim(Expression condition) {
        letters.claim(letters.truth(condition));
    }

    void claimNot(int condition) {
        letters.claim(-condition);
    }

    void claim(int condition) {
        letters.claim(condition);
    }

    /** That the right side takes a step that allows what the left one sends. */
    int answers(PossibleStep mine, PossibleStep theirs) {
        List<Integer> all = new ArrayList<>(List.of(letters.truth(theirs.when())));
        for (Port port : observed) {
            all.add(allows(theirs.sent(port), mine.sent(port)));
        }
        return letters.and(all);
    }

    private int allows(Emitted theirs, Emitted mine) {
        return theirs.message().isPresent() && mine.message().isPresent()
                ? letters.areSame(theirs.message().get(), mine.message().get())
                : truth(theirs.allows(mine));
    }

    int truth(Claim claim) {
        return claim.asked()
                .map(e -> claim.relation().isDenied() ? -letters.truth(e) : letters.truth(e))
                .orElseGet(() -> letters.areSame(claim.one(), claim.other()));
    }

    /** That is known. */
    int truth(boolean known) {
        int always = letters.and(List.of());
        return known ? always : -always;
    }

    /** That comparisons are true after a step of both. */
    int leadsTo(List<Comparison> after, PossibleStep mine, PossibleStep theirs) {
        return letters.and(
                after.stream().map(each -> truth(Slice.after(each, mine, theirs))).toList());
    }

    int and(int one, int other) {
        return letters.and(List.of(one, other));
    }

    /**
     * By position of the slice's port; empty where it is proved that there is nothing.
     *
     * @throws arcomat.semantics.value.GivenUp where that takes too long
     */
    Optional<Value[]> find() {
        return letters.find();
    }

    /** How much has been done so far: equal on every machine. */
    long work() {
        return letters.work();
    }
}
