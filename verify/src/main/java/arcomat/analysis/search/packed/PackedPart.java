package arcomat.analysis.search.packed;

import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;
import arcomat.semantics.network.Network;

import com.carrotsearch.hppc.IntArrayList;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The steps of a part, ready to be put together in one layout. */
final class PackedPart {
    /** Up to so many bits of what a part reads, its steps lie in a table with a place for each. */
    private static final int SMALL = 12;

    /**
     * The steps with one input.
     *
     * @param count how many there are
     * @param ends whether the first of them ends the run
     * @param bits of the configuration afterwards and of what is shown, step by step
     * @param instant what is sent without delay, step by step
     */
    record Packed(int count, boolean ends, long[] bits, int[] instant) {
        /** Whether there is nothing to choose. */
        boolean isCertain() {
            return count == 1 && !ends;
        }
    }

    final int field;

    /** Signals by input port; -1 where nothing is connected. */
    final int[] inputs;

    /** The signals that it sends on without delay. */
    final int[] instant;

    private final SliceNetwork network;
    private final int part;
    private final PartOutcomes rows;
    private final PackedLayout layout;
    private final PackedLayout shown;
    private final int[] bits;
    private final int[] outputs;

    /** The configuration, then the inputs, each with the bits of its signal. */
    private final PackedLayout key;

    private final long[] keyWords;
    private final @Nullable Packed[] small;
    private final IntArrayList looks = new IntArrayList();
    private final PackedTable keys;
    private final List<Packed> large = new ArrayList<>();

    /**
     * @param bits per signal, of what it carries
     * @param shown where what is shown stands in one word
     */
    PackedPart(
            SliceNetwork network, int part, PackedLayout layout, int[] bits, PackedLayout shown) {
        Network.Instance instance = network.network.instances().get(part);
        this.network = network;
        this.rows = network.parts.get(part);
        this.layout = layout;
        this.shown = shown;
        this.bits = bits;
        this.part = part;
        field = network.partField[part];
        inputs = instance.inputSignals().stream().mapToInt(Integer::intValue).toArray();
        outputs = instance.outputSignals().stream().mapToInt(Integer::intValue).toArray();
        instant = Arrays.stream(outputs).filter(s -> !network.delayed[s]).toArray();
        int[] widths = new int[inputs.length + 1];
        widths[0] = layout.width(field);
        for (int i = 0; i < inputs.length; i++) {
            widths[i + 1] = inputs[i] < 0 ? 0 : bits[inputs[i]];
        }
        key = PackedLayout.of(widths);
        keyWords = new long[key.words()];
        int all = Arrays.stream(widths).sum();
        small = new Packed[all <= SMALL ? 1 << all : 0];
        keys = new PackedTable(key.words());
    }

    /** A number for how it looks at what comes from outside. */
    int look(int configuration) {
        while (looks.size() <= configuration) {
            looks.add(network.look(part, looks.size()));
        }
        return looks.get(configuration);
    }

    /**
     * @param on what is on each signal
     */
    Packed steps(int configuration, int[] on) {
        return small.length > 0 ? small(configuration, on) : large(configuration, on);
    }

    /** Where messages that look alike have places of their own. */
    private Packed small(int configuration, int[] on) {
        int place = configuration;
        for (int port = 0; port < inputs.length; port++) {
            if (inputs[port] >= 0) {
                place |= on[inputs[port]] << key.shift(port + 1);
            }
        }
        Packed known = small[place];
        if (known == null) {
            known = packed(configuration, on);
            small[place] = known;
        }
        return known;
    }

    private Packed large(int configuration, int[] on) {
        Arrays.fill(keyWords, 0);
        key.put(keyWords, 0, configuration);
        int[][] kinds = rows.kinds(configuration);
        for (int port = 0; port < inputs.length; port++) {
            if (inputs[port] >= 0) {
                int message = on[inputs[port]];
                int[] known = kinds[port];
                int kind =
                        message < known.length
                                ? known[message]
                                : rows.kind(configuration, port, message);
                key.put(keyWords, port + 1, kind);
            }
        }
        int number = keys.find(keyWords);
        return number >= 0 ? large.get(number) : added(configuration, on);
    }

    private Packed added(int configuration, int[] on) {
        Packed packed = packed(configuration, on);
        keys.add(keyWords);
        large.add(packed);
        return packed;
    }

    private Packed packed(int configuration, int[] on) {
        int[] messages = new int[inputs.length];
        for (int port = 0; port < messages.length; port++) {
            messages[port] = inputs[port] < 0 ? -1 : on[inputs[port]];
        }
        int[] row = rows.row(configuration, messages).numbers();
        int stride = 1 + outputs.length;
        int count = row.length / stride;
        long[] words = new long[count * (layout.words() + 1)];
        int[] sent = new int[count * instant.length];
        boolean ends = false;
        for (int step = 0; step < count; step++) {
            boolean end = row[step * stride] == PartOutcomes.END;
            ends |= end;
            if (!end) {
                put(row, step, words, sent);
            }
        }
        return new Packed(count, ends, words, sent);
    }

    private void put(int[] row, int step, long[] words, int[] sent) {
        long[] after = new long[layout.words()];
        long[] seen = new long[1];
        int from = step * (1 + outputs.length);
        if (!layout.fits(field, row[from])) {
            throw new TooNarrow();
        }
        layout.put(after, field, row[from]);
        int next = step * instant.length;
        for (int port = 0; port < outputs.length; port++) {
            int signal = outputs[port];
            int message = row[from + 1 + port];
            network.refuseOpen(signal, message);
            if (message >>> bits[signal] != 0) {
                throw new TooNarrow();
            }
            if (network.signalField[signal] >= 0) {
                layout.put(after, network.signalField[signal], message);
            } else if (!network.delayed[signal]) {
                sent[next++] = message;
            }
            for (int i = 0; i < network.observed.length; i++) {
                if (network.observed[i] == signal) {
                    shown.put(seen, i, message);
                }
            }
        }
        System.arraycopy(after, 0, words, step * (after.length + 1), after.length);
        words[step * (after.length + 1) + after.length] = seen[0];
    }
}
