package arcomat.analysis.search.letter;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Which latched ports hold a message, as a bit for each: one that has got a message holds one from
 * then on, so that no environment can take it back.
 *
 * @param positions of the latched ports among the inputs; none where inputs come in slices
 */
public record LatchedPorts(List<Integer> positions) {

    public static LatchedPorts of(Component.Profile profile, List<Port> inputs) {
        boolean events = profile == Component.Profile.EVENT_DRIVEN;
        return new LatchedPorts(
                IntStream.range(0, inputs.size())
                        .filter(i -> events && inputs.get(i).latched())
                        .boxed()
                        .toList());
    }

    /** It always matters whether they hold something. */
    public InputAbstraction abstraction(int inputs) {
        List<PortAbstraction> looks = new ArrayList<>(InputAbstraction.none(inputs).looks());
        positions.forEach(port -> looks.set(port, new Compared(List.of(), false)));
        return new InputAbstraction(looks);
    }

    /** What they hold when a letter is read. */
    public long held(Value[] letter) {
        long held = 0;
        for (int i = 0; i < positions.size(); i++) {
            held |= letter[positions.get(i)] == null ? 0 : 1L << i;
        }
        return held;
    }

    /** Whether a letter may follow where so much was held before. */
    public boolean isPossible(long before, Value[] letter) {
        return (before & ~held(letter)) == 0;
    }
}
