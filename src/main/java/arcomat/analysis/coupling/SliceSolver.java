package arcomat.analysis.coupling;

import arcomat.analysis.bits.BitLetters;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** One question about a slice: whether there are messages and variables for something. */
final class SliceSolver {
    private final BitLetters letters;
    private final List<Port> observed;

    /**
     * @param before what is known of variables
     * @param stop asked now and then, whether to give up
     */
    SliceSolver(Slice slice, List<Comparison> before, List<Port> observed, BooleanSupplier stop) {
        this.observed = observed;
        letters = new BitLetters(slice.ports(), stop);
        before.forEach(each -> claim(each.expression()));
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

    /** That is known. */
    int truth(boolean known) {
        int always = letters.and(List.of());
        return known ? always : -always;
    }

    /** That comparisons are true after a step of both. */
    int leadsTo(List<Comparison> after, PossibleStep mine, PossibleStep theirs) {
        return letters.and(
                after.stream()
                        .map(each -> letters.truth(Slice.after(each, mine, theirs)))
                        .toList());
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
}
