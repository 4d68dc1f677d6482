package arcomat.analysis.search.packed;

import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;
import arcomat.analysis.search.packed.PackedPart.Packed;
import arcomat.semantics.expression.Sent;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * All ways through a slice, one after the other, in the order in which the unfolding has them: the
 * choices of the last part change first. Parts that read nothing but what was sent a slice ago are
 * asked once for all inputs, parts without a choice once for all ways.
 */
final class PackedSlices implements PackedSteps {
    private final SliceNetwork network;
    private final PackedLayout layout;
    private final PackedPart[] parts;

    /** Words of a configuration and one more, of what is shown. */
    private final int words;

    private final PackedLayout shown;
    private final int[] bits;

    /** Whether a part reads only what was sent a slice ago. */
    private final boolean[] late;

    private final int[] externalParts;
    private final int lookBits;

    /** What is on each signal. */
    private final int[] on;

    /** Whether that is the same on all ways. */
    private final boolean[] certain;

    private final int[] before;

    /** The steps of those parts whose input is the same on all ways. */
    private final Packed[] steps;

    private final boolean[] known;
    private final long[] certainBits;

    /** Parts that are no matter of the configuration before alone. */
    private final int[] open;

    private int openCount;

    /** Parts with a choice, and those that read what depends on one. */
    private final int[] active;

    private int activeCount;
    private final Packed[] ofActive;
    private final int[] choice;

    /** What the ways have in common so far, by active part. */
    private final long[] way;

    private int depth;
    private boolean fresh;
    private boolean ended;

    /**
     * @param layout that of the network
     */
    PackedSlices(SliceNetwork network, PackedLayout layout) {
        this.network = network;
        this.layout = layout;
        int count = network.parts.size();
        int signals = network.messages.size();
        bits = IntStream.range(0, signals).map(this::bits).toArray();
        shown = PackedLayout.of(Arrays.stream(network.observed).map(s -> bits[s]).toArray());
        if (shown.words() > 1) {
            throw new CannotPack("too much is compared");
        }
        words = layout.words() + 1;
        parts = new PackedPart[count];
        late = new boolean[count];
        for (int part = 0; part < count; part++) {
            parts[part] = new PackedPart(network, part, layout, bits, shown);
            late[part] =
                    Arrays.stream(parts[part].inputs).allMatch(s -> s < 0 || network.delayed[s]);
        }
        externalParts =
                IntStream.range(0, count)
                        .filter(p -> Arrays.stream(parts[p].inputs).anyMatch(network::isExternal))
                        .toArray();
        lookBits = Math.min(16, (Long.SIZE - 1) / Math.max(1, externalParts.length));
        on = new int[signals];
        certain = new boolean[signals];
        before = new int[count];
        steps = new Packed[count];
        known = new boolean[count];
        certainBits = new long[words];
        open = new int[count];
        active = new int[count];
        ofActive = new Packed[count];
        choice = new int[count];
        way = new long[(count + 1) * words];
    }

    /** What is kept may have any value that fits, what is not kept has been met. */
    private int bits(int signal) {
        int field = network.signalField[signal];
        return field < 0 ? network.bitsOf(signal) : layout.width(field);
    }

    @Override
    public void begin(long[] configuration) {
        for (int signal = 0; signal < on.length; signal++) {
            boolean delayed = network.signalField[signal] >= 0;
            on[signal] = delayed ? layout.get(configuration, network.signalField[signal]) : 0;
            certain[signal] = delayed || network.isExternal(signal);
        }
        Arrays.fill(certainBits, 0);
        openCount = 0;
        for (int part = 0; part < parts.length; part++) {
            before[part] = layout.get(configuration, parts[part].field);
            known[part] = late[part];
            if (late[part]) {
                steps[part] = parts[part].steps(before[part], on);
            }
            if (late[part] && steps[part].isCertain()) {
                settle(part, certainBits);
            } else {
                open[openCount++] = part;
            }
        }
    }

    /** What all ways have in common. */
    private void settle(int part, long[] into) {
        Packed step = steps[part];
        for (int word = 0; word < words; word++) {
            into[word] |= step.bits()[word];
        }
        send(part, step, 0);
        for (int signal : parts[part].instant) {
            certain[signal] = true;
        }
    }

    private void send(int part, Packed step, int which) {
        int[] signals = parts[part].instant;
        for (int i = 0; i < signals.length; i++) {
            on[signals[i]] = step.instant()[which * signals.length + i];
        }
    }

    @Override
    public long looks() {
        long looks = 0;
        for (int part : externalParts) {
            int look = parts[part].look(before[part]);
            if (look >>> lookBits != 0) {
                throw new CannotPack("inputs are looked at in too many ways");
            }
            looks = looks << lookBits | look;
        }
        return looks;
    }

    @Override
    public void read(int[] messages) {
        System.arraycopy(certainBits, 0, way, 0, words);
        for (int input = 0; input < messages.length; input++) {
            int signal = network.network.inputs().get(input).signal();
            if (messages[input] >>> bits[signal] != 0) {
                throw new TooNarrow();
            }
            on[signal] = messages[input];
        }
        showInputs();
        activeCount = 0;
        for (int i = 0; i < openCount; i++) {
            read(open[i]);
        }
        depth = -1;
        fresh = true;
    }

    /** An input that goes straight to an output. */
    private void showInputs() {
        for (int i = 0; i < network.observed.length; i++) {
            if (network.isExternal(network.observed[i])) {
                way[words - 1] |= (long) on[network.observed[i]] << shown.shift(i);
            }
        }
    }

    private void read(int part) {
        if (!late[part]) {
            known[part] = isCertain(parts[part].inputs);
            if (known[part]) {
                steps[part] = parts[part].steps(before[part], on);
            }
        }
        if (known[part] && steps[part].isCertain()) {
            Packed step = steps[part];
            for (int word = 0; word < words; word++) {
                way[word] |= step.bits()[word];
            }
            send(part, step, 0);
        } else {
            active[activeCount++] = part;
        }
        boolean sure = activeCount == 0 || active[activeCount - 1] != part;
        for (int signal : parts[part].instant) {
            certain[signal] = sure;
        }
    }

    private boolean isCertain(int[] inputs) {
        for (int signal : inputs) {
            if (signal >= 0 && !certain[signal]) {
                return false;
            }
        }
        return true;
    }

    @Override
    public boolean next() {
        if (fresh) {
            fresh = false;
            ended = false;
            if (activeCount == 0) {
                return true;
            }
            depth = 0;
            enter();
        }
        while (depth >= 0) {
            choice[depth]++;
            Packed step = ofActive[depth];
            if (choice[depth] >= step.count()) {
                depth--;
                continue;
            }
            ended = step.ends() && choice[depth] == 0;
            choose(step);
            if (ended || depth + 1 == activeCount) {
                return true;
            }
            depth++;
            enter();
        }
        return false;
    }

    private void enter() {
        int part = active[depth];
        ofActive[depth] = known[part] ? steps[part] : parts[part].steps(before[part], on);
        choice[depth] = -1;
    }

    private void choose(Packed step) {
        int from = depth * words;
        int chosen = choice[depth] * words;
        for (int word = 0; word < words; word++) {
            way[from + words + word] = way[from + word] | step.bits()[chosen + word];
        }
        send(active[depth], step, choice[depth]);
    }

    @Override
    public boolean hasEnded() {
        return ended;
    }

    @Override
    public void after(long[] into) {
        if (ended) {
            Arrays.fill(into, 0);
        } else {
            System.arraycopy(way, end(), into, 0, words - 1);
        }
    }

    @Override
    public long shown() {
        return way[end() + words - 1];
    }

    private int end() {
        return activeCount * words;
    }

    @Override
    public Sent shown(long number, int signal) {
        for (int i = 0; i < network.observed.length; i++) {
            if (network.observed[i] == signal) {
                return network.messages.get(signal).get(shown.get(new long[] {number}, i));
            }
        }
        throw new IllegalArgumentException("signal " + signal + " is not observed");
    }
}
