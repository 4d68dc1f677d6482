package arcomat.analysis.engine;

import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Attention;
import arcomat.semantics.Attention.Look;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * One letter of each kind that some foci together tell apart: few messages first, then in the order
 * in which ports and values are declared. Ports that nobody looks at stay silent.
 */
public final class Alphabet {
    /** More letters than that are not tried at once. */
    static final int MOST = 1_000_000;

    private final List<Value[]> letters = new ArrayList<>();
    private final int[] messages;
    private final long[][] kinds;

    /**
     * @param inputs of the letters
     * @param foci each with the positions of its ports in a letter
     * @param positions one array per focus
     */
    public Alphabet(List<Port> inputs, List<Focus> foci, List<int[]> positions) {
        Look[] looks = new Look[inputs.size()];
        java.util.Arrays.fill(looks, new arcomat.semantics.Attention.Unseen());
        for (int f = 0; f < foci.size(); f++) {
            List<Look> own = foci.get(f).attention().looks();
            for (int i = 0; i < own.size(); i++) {
                int position = positions.get(f)[i];
                looks[position] = looks[position].and(own.get(i));
            }
        }
        fill(inputs, looks);
        letters.sort(Comparator.comparingInt(Alphabet::messages));
        messages = letters.stream().mapToInt(Alphabet::messages).toArray();
        kinds = new long[foci.size()][letters.size()];
        for (int f = 0; f < foci.size(); f++) {
            for (int i = 0; i < messages.length; i++) {
                kinds[f][i] = foci.get(f).kind(letters.get(i), positions.get(f));
            }
        }
    }

    /**
     * The letters that one attention tells apart.
     *
     * @throws TooManyMessages where all values of a port matter and there are too many to try
     */
    public static Alphabet of(List<Port> inputs, Attention attention) {
        int[] positions = IntStream.range(0, inputs.size()).toArray();
        Focus focus = new Focus(0, attention, inputs);
        return new Alphabet(inputs, List.of(focus), List.of(positions));
    }

    private void fill(List<Port> inputs, Look[] looks) {
        letters.add(new Value[inputs.size()]);
        for (int port = 0; port < looks.length; port++) {
            Port input = inputs.get(port);
            List<Value> samples = Kinds.of(input, input.total(), looks[port]).samples();
            if ((long) letters.size() * samples.size() > MOST) {
                throw new TooManyMessages(input);
            }
            List<Value[]> longer = new ArrayList<>(letters.size() * samples.size());
            for (Value[] letter : letters) {
                for (Value sample : samples) {
                    Value[] copy = letter.clone();
                    copy[port] = sample;
                    longer.add(copy);
                }
            }
            letters.clear();
            letters.addAll(longer);
        }
    }

    private static int messages(Value[] letter) {
        int count = 0;
        for (Value message : letter) {
            count += message == null ? 0 : 1;
        }
        return count;
    }

    public int size() {
        return messages.length;
    }

    /** Messages by position of the port, null for silence; not to be written to. */
    public Value[] letter(int index) {
        return letters.get(index);
    }

    public int messages(int index) {
        return messages[index];
    }

    /** The number of a letter for one of the foci. */
    public long kind(int focus, int index) {
        return kinds[focus][index];
    }
}
