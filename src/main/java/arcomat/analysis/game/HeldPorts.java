package arcomat.analysis.game;

import arcomat.analysis.search.letter.LetterClasses;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.Attention;
import arcomat.semantics.value.Attention.Compared;
import arcomat.semantics.value.Attention.Look;
import arcomat.semantics.value.Attention.Unseen;
import arcomat.semantics.value.GivenUp;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Which latched ports hold a message: one that has got one never loses it, so that the environment
 * cannot take it back. A bit for each.
 */
final class HeldPorts {
    private final List<Integer> latched;
    private final LetterClasses focus;

    private HeldPorts(List<Integer> latched, LetterClasses focus) {
        this.latched = latched;
        this.focus = focus;
    }

    static HeldPorts of(Component.Profile profile, List<Port> inputs) {
        boolean events = profile == Component.Profile.EVENT_DRIVEN;
        List<Integer> latched =
                IntStream.range(0, inputs.size())
                        .filter(i -> events && inputs.get(i).latched())
                        .boxed()
                        .toList();
        if (latched.size() > Integer.SIZE) {
            throw new GivenUp("more than " + Integer.SIZE + " latched ports");
        }
        List<Look> looks =
                inputs.stream()
                        .<Look>map(
                                port ->
                                        events && port.latched()
                                                ? new Compared(List.of(), false)
                                                : new Unseen())
                        .toList();
        return new HeldPorts(latched, new LetterClasses(0, new Attention(looks), inputs));
    }

    /** It always matters whether they hold something. */
    LetterClasses focus() {
        return focus;
    }

    /** Before anything is read. */
    int atFirst() {
        return 0;
    }

    int after(Value[] letter) {
        int held = 0;
        for (int i = 0; i < latched.size(); i++) {
            held |= letter[latched.get(i)] == null ? 0 : 1 << i;
        }
        return held;
    }

    boolean isPossible(int before, Value[] letter) {
        return (before & ~after(letter)) == 0;
    }
}
