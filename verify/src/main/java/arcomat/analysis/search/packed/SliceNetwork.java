package arcomat.analysis.search.packed;

import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.reduction.EqualParts;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * A time-synchronous network in numbers.
 *
 * <p>The fields of a configuration are those of the parts, each followed by those of the delayed
 * signals that it sends, and the mark.
 */
public final class SliceNetwork extends PackedNetwork {
    final Network network;
    final boolean[] delayed;
    final List<Numbering<Sent>> messages = new ArrayList<>();
    final List<PartOutcomes> parts = new ArrayList<>();

    /** Per signal, whether a part reads it, or more than one output shows it. */
    final boolean[] read;

    /** Signals that compared outputs show, each once. */
    final int[] observed;

    private final List<EqualParts> equal;
    private final boolean[] external;

    private final Numbering<List<PortAbstraction>> externalLooks = new Numbering<>();

    final int[] partField;

    /** Per signal; -1 for one that no configuration has. */
    final int[] signalField;

    private final int markField;
    private final List<List<Integer>> alike;

    /**
     * @param behaviours one per instance
     * @param observed the signals of compared outputs, of those that are connected
     * @param equal parts that share their numbers, so that they can change places
     * @param between called before what may take long; may throw to give up
     * @param takes whether a shortcut may be taken
     */
    public SliceNetwork(
            Network network,
            List<ComponentSemantics> behaviours,
            int[] observed,
            List<EqualParts> equal,
            Runnable between,
            Predicate<Shortcut> takes) {
        if (behaviours.isEmpty()) {
            throw new CannotPack("no parts");
        }
        this.network = network;
        this.observed = IntStream.of(observed).distinct().toArray();
        this.external = new boolean[network.signals()];
        network.inputs().forEach(input -> external[input.signal()] = true);
        this.delayed = new boolean[network.signals()];
        this.read = new boolean[network.signals()];
        network.delayed().forEach(signal -> delayed[signal] = true);
        for (int signal = 0; signal < network.signals(); signal++) {
            messages.add(new Numbering<>());
        }
        this.equal = List.copyOf(equal);
        int[] alikeParts = shareNumbers();
        partField = new int[behaviours.size()];
        signalField = new int[network.signals()];
        Arrays.fill(signalField, -1);
        for (int part = 0; part < partField.length; part++) {
            Network.Instance instance = network.instances().get(part);
            parts.add(
                    alikeParts[part] < part
                            ? parts.get(alikeParts[part])
                            : new PartOutcomes(
                                    behaviours.get(part),
                                    numbers(instance.inputSignals()),
                                    numbers(instance.outputSignals()),
                                    () -> compute(between),
                                    () -> takes.test(Shortcut.ALIKE)));
            instance.inputSignals().stream().filter(s -> s >= 0).forEach(s -> read[s] = true);
        }
        boolean[] kept = kept(takes);
        int field = 0;
        for (int part = 0; part < partField.length; part++) {
            partField[part] = field++;
            for (int signal : network.instances().get(part).outputSignals()) {
                signalField[signal] = kept[signal] ? field++ : -1;
            }
        }
        for (int i = 0; i < observed.length; i++) {
            for (int j = 0; j < i; j++) {
                read[observed[i]] |= observed[i] == observed[j];
            }
        }
        markField = field;
        alike = alike(network);
        parts.get(0).number(ENDED);
    }

    /** By part and by signal. */
    @Override
    public int[] met() {
        return IntStream.concat(
                        parts.stream().mapToInt(PartOutcomes::size),
                        messages.stream().mapToInt(Numbering::size))
                .toArray();
    }

    @Override
    Object thing(int kind, int number) {
        return kind < parts.size()
                ? parts.get(kind).configuration(number)
                : messages.get(kind - parts.size()).get(number);
    }

    /** Per signal, whether it has delay, and somebody reads it. */
    private boolean[] kept(Predicate<Shortcut> takes) {
        boolean[] kept = delayed.clone();
        for (int signal = 0; signal < kept.length; signal++) {
            kept[signal] &= read[signal] || !takes.test(Shortcut.CONE);
        }
        return kept;
    }

    /** What equal parts send has the same numbers; per part the first one that is equal. */
    private int[] shareNumbers() {
        int[] first = IntStream.range(0, network.instances().size()).toArray();
        for (EqualParts each : equal) {
            for (int[] group : each.groups()) {
                for (int i = 0; i < group.length; i++) {
                    share(each.groups().get(0)[i], group[i]);
                }
            }
        }
        for (EqualParts each : equal) {
            for (int i = 0; i < each.groups().get(0).length; i++) {
                int position = i;
                int least = each.groups().stream().mapToInt(g -> g[position]).min().orElseThrow();
                each.groups().forEach(group -> first[group[position]] = least);
            }
        }
        return first;
    }

    private void share(int part, int other) {
        List<Integer> own = network.instances().get(part).outputSignals();
        List<Integer> others = network.instances().get(other).outputSignals();
        for (int port = 0; port < own.size(); port++) {
            messages.set(others.get(port), messages.get(own.get(port)));
        }
    }

    @Override
    public Consumer<long[]> canonical(PackedLayout layout) {
        List<CanonicalForm> forms = new ArrayList<>();
        for (EqualParts each : equal) {
            List<int[]> fields = each.groups().stream().map(this::fields).toList();
            if (CanonicalForm.fits(fields.get(0), layout)) {
                forms.add(new CanonicalForm(each.ring(), fields, layout));
            }
        }
        if (forms.size() == 1) {
            return forms.get(0)::apply;
        }
        return key -> forms.forEach(form -> form.apply(key));
    }

    private int[] fields(int[] group) {
        return Arrays.stream(group)
                .flatMap(
                        part ->
                                IntStream.concat(
                                        IntStream.of(partField[part]),
                                        network.instances().get(part).outputSignals().stream()
                                                .mapToInt(signal -> signalField[signal])
                                                .filter(field -> field >= 0)))
                .toArray();
    }

    @Override
    public List<String> equalParts() {
        return equal.stream().map(each -> each.text(network)).toList();
    }

    private List<Numbering<Sent>> numbers(List<Integer> signals) {
        return signals.stream().map(s -> s < 0 ? new Numbering<Sent>() : messages.get(s)).toList();
    }

    /**
     * With bits for all that has been met; a part gets as many as others of its kind, since it will
     * need them sooner or later.
     */
    @Override
    public PackedLayout layout() {
        List<Integer> widths = new ArrayList<>();
        for (int part = 0; part < partField.length; part++) {
            Network.Instance instance = network.instances().get(part);
            List<Integer> most = new ArrayList<>();
            for (int other : alike.get(part)) {
                widen(most, other);
            }
            widths.add(most.get(0));
            for (int port = 0; port < instance.outputSignals().size(); port++) {
                if (signalField[instance.outputSignals().get(port)] >= 0) {
                    widths.add(most.get(port + 1));
                }
            }
        }
        widths.add(markBits());
        return PackedLayout.of(widths.stream().mapToInt(Integer::intValue).toArray());
    }

    /** Bits of the configuration, then of the signals by output port. */
    private void widen(List<Integer> most, int part) {
        List<Integer> own = new ArrayList<>(List.of(bits(parts.get(part).size())));
        network.instances().get(part).outputSignals().forEach(s -> own.add(bitsOf(s)));
        for (int i = 0; i < own.size(); i++) {
            if (i == most.size()) {
                most.add(own.get(i));
            } else {
                most.set(i, Math.max(most.get(i), own.get(i)));
            }
        }
    }

    @Override
    public int markField() {
        return markField;
    }

    /** For what has been met on a signal. */
    int bitsOf(int signal) {
        return bits(messages.get(signal).size());
    }

    @Override
    public void pack(GlobalState state, PackedLayout layout, long[] into) {
        Arrays.fill(into, 0);
        if (state.isError()) {
            return;
        }
        for (int part = 0; part < partField.length; part++) {
            put(layout, into, partField[part], parts.get(part).number(state.parts().get(part)));
        }
        for (int signal = 0; signal < signalField.length; signal++) {
            if (signalField[signal] >= 0) {
                int message = number(signal, state.registers().get(signal));
                put(layout, into, signalField[signal], message);
            }
        }
    }

    /** The number of what is on a signal. */
    int number(int signal, Sent sent) {
        int message = messages.get(signal).number(sent);
        refuseOpen(signal, message);
        return message;
    }

    void refuseOpen(int signal, int message) {
        if (read[signal] && !(messages.get(signal).get(message) instanceof Sent.Messages)) {
            throw new CannotPack("what is read is left open");
        }
    }

    /** The number of a message from outside, by position of the external input. */
    int external(int input, @Nullable Value message) {
        return number(network.inputs().get(input).signal(), Sent.of(message));
    }

    @Override
    public int[] letter(Value[] letter) {
        int[] numbers = new int[letter.length];
        for (int input = 0; input < numbers.length; input++) {
            numbers[input] = external(input, letter[input]);
        }
        return numbers;
    }

    @Override
    public PackedSteps steps(PackedLayout layout) {
        return new PackedSlices(this, layout);
    }

    @Override
    public boolean hasEnded(long[] from, PackedLayout layout) {
        return layout.get(from, partField[0]) == 0;
    }

    @Override
    public GlobalState unpack(long[] from, PackedLayout layout) {
        if (hasEnded(from, layout)) {
            return new GlobalState(List.of(ENDED), List.of());
        }
        List<List<Configuration>> configurations = new ArrayList<>();
        for (int part = 0; part < partField.length; part++) {
            configurations.add(parts.get(part).configuration(layout.get(from, partField[part])));
        }
        List<Sent> registers = new ArrayList<>();
        for (int signal = 0; signal < signalField.length; signal++) {
            registers.add(
                    signalField[signal] < 0
                            ? Sent.SILENCE
                            : messages.get(signal).get(layout.get(from, signalField[signal])));
        }
        return new GlobalState(configurations, registers);
    }

    /** A number for how a part looks at what comes from outside, in a configuration. */
    int look(int part, int configuration) {
        List<PortAbstraction> looks = new ArrayList<>();
        List<Integer> signals = network.instances().get(part).inputSignals();
        for (int port = 0; port < signals.size(); port++) {
            if (isExternal(signals.get(port))) {
                looks.add(parts.get(part).look(configuration, port));
            }
        }
        return externalLooks.number(looks);
    }

    boolean isExternal(int signal) {
        return signal >= 0 && external[signal];
    }
}
