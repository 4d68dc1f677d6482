package arcomat.analysis.engine;

import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Attention;

import java.util.List;

/**
 * What a configuration pays attention to, ready to sort letters: all letters with one number have
 * the same steps.
 */
public final class Focus {
    private final int number;
    private final Attention attention;
    private final Kinds[] kinds;
    private final int[] ports;
    private final long[] strides;

    public Focus(int number, Attention attention, List<Port> inputs) {
        this.number = number;
        this.attention = attention;
        kinds = new Kinds[inputs.size()];
        strides = new long[inputs.size()];
        long stride = 1;
        int seen = 0;
        int[] all = new int[inputs.size()];
        for (int i = 0; i < kinds.length; i++) {
            kinds[i] = Kinds.of(inputs.get(i), false, attention.looks().get(i));
            strides[i] = stride;
            stride = Math.multiplyExact(stride, (long) kinds[i].count());
            if (kinds[i].count() > 1) {
                all[seen++] = i;
            }
        }
        ports = java.util.Arrays.copyOf(all, seen);
    }

    /** Foci of one side are numbered from 0. */
    public int number() {
        return number;
    }

    /** What is looked at, port by port. */
    public Attention attention() {
        return attention;
    }

    /**
     * The number of a letter.
     *
     * @param letter messages by position
     * @param positions where the ports of this side stand in the letter
     */
    public long kind(Value[] letter, int[] positions) {
        long kind = 0;
        for (int port : ports) {
            kind += strides[port] * kinds[port].of(letter[positions[port]]);
        }
        return kind;
    }
}
