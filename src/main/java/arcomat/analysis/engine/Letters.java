package arcomat.analysis.engine;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Attention;
import arcomat.semantics.Attention.Look;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * One letter of each kind that a single configuration tells apart: few messages first, then in the
 * order in which ports and values are declared.
 */
public final class Letters {
    private Letters() {}

    /**
     * Messages by position of the input port, null for silence; not to be written to.
     *
     * @throws TooManyMessages where all messages of a port matter that has too many
     */
    public static List<Value[]> of(Component component, Attention attention) {
        return component.profile() == Component.Profile.EVENT_DRIVEN
                ? events(component.inputs(), attention.looks())
                : slices(component.inputs(), attention);
    }

    /** Each port may carry a message. */
    private static List<Value[]> slices(List<Port> inputs, Attention attention) {
        int[] positions = IntStream.range(0, inputs.size()).toArray();
        Focus focus = new Focus(0, attention, inputs);
        Alphabet alphabet = new Alphabet(inputs, List.of(focus), List.of(positions));
        return IntStream.range(0, alphabet.size()).mapToObj(alphabet::letter).toList();
    }

    /** One port has an event, and latched ports may have got a message before. */
    private static List<Value[]> events(List<Port> inputs, List<Look> looks) {
        List<Value[]> letters = new ArrayList<>();
        for (int port = 0; port < inputs.size(); port++) {
            if (!inputs.get(port).latched()) {
                Value[] silence = new Value[inputs.size()];
                letters.addAll(with(port, true, List.<Value[]>of(silence), inputs, looks));
            }
        }
        for (int port = 0; port < inputs.size(); port++) {
            if (inputs.get(port).latched()) {
                letters = with(port, false, letters, inputs, looks);
            }
        }
        letters.sort(Comparator.comparingInt(Letters::messages));
        return letters;
    }

    private static List<Value[]> with(
            int port, boolean present, List<Value[]> letters, List<Port> inputs, List<Look> looks) {
        List<Value> samples = Kinds.of(inputs.get(port), present, looks.get(port)).samples();
        if ((long) letters.size() * samples.size() > Alphabet.MOST) {
            throw new TooManyMessages(inputs.get(port));
        }
        List<Value[]> longer = new ArrayList<>(letters.size() * samples.size());
        for (Value[] letter : letters) {
            for (Value sample : samples) {
                Value[] copy = letter.clone();
                copy[port] = sample;
                longer.add(copy);
            }
        }
        return longer;
    }

    /** How many ports carry a message. */
    public static int messages(Value[] letter) {
        int count = 0;
        for (Value message : letter) {
            count += message == null ? 0 : 1;
        }
        return count;
    }
}
