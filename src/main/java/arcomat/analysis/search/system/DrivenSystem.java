package arcomat.analysis.search.system;

import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.step.StepCollector;
import arcomat.analysis.search.step.Steps;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.value.Attention;
import arcomat.semantics.value.Attention.Look;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * A side as its surroundings really drive it: a latched port that has got a message holds one from
 * then on. Letters in which it is empty again cannot happen, and have no steps. Only for the left
 * side of a comparison; the right one then meets no other letters.
 *
 * <p>Remembers a bit for each latched port that holds something.
 */
public final class DrivenSystem extends HistorySystem<Long> {
    private final List<Integer> latched;
    private final Map<Attention, LetterClasses> foci = new HashMap<>();

    private DrivenSystem(TransitionSystem side) {
        super(side);
        this.latched =
                IntStream.of(positions).filter(i -> inputs().get(i).latched()).boxed().toList();
    }

    /** The side itself if it has no latched ports. */
    public static TransitionSystem of(TransitionSystem side) {
        DrivenSystem driven = new DrivenSystem(side);
        boolean any = !driven.latched.isEmpty() && driven.latched.size() < Long.SIZE;
        return any && side.profile() == Component.Profile.EVENT_DRIVEN ? driven : side;
    }

    @Override
    public Steps openings() {
        return remembering(side.openings(), 0L);
    }

    /** Of a latched port it always matters whether it holds something. */
    @Override
    public LetterClasses focus(int configuration) {
        List<Look> looks =
                new ArrayList<>(side.focus(state(configuration).inner()).attention().looks());
        for (int port : latched) {
            looks.set(port, looks.get(port).and(new Attention.Compared(List.of(), false)));
        }
        return foci.computeIfAbsent(
                new Attention(looks), each -> new LetterClasses(foci.size(), each, inputs()));
    }

    @Override
    Steps compute(State<Long> before, long kind, Value[] letter) {
        long now = 0;
        for (int i = 0; i < latched.size(); i++) {
            now |= letter[latched.get(i)] == null ? 0 : 1L << i;
        }
        if ((before.memory() & ~now) != 0) {
            return new StepCollector().steps();
        }
        return remembering(own(before.inner(), letter), now);
    }

    @Override
    String words(Long held) {
        return held == 0 ? "" : Long.toBinaryString(held);
    }
}
