package arcomat.analysis.search.letter;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.DataSorts.Sort;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.Copied;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.MessageClasses;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;

/**
 * The letters that a pair of configurations tells apart, where of some data it only matters which
 * of them are the same: a port carries a constant, a value that the pair holds, or a stranger. Of
 * strangers it takes as many as ports may carry at once.
 *
 * @param sorts by position of the port; null where its data are not free
 * @param held by number of the sort, what the pair holds of it, in natural order
 */
public record Representatives(Sort[] sorts, Map<Integer, List<Value>> held) {
    public static final Representatives NONE = new Representatives(new Sort[0], Map.of());

    /** Whether it only matters which data of a port are the same. */
    boolean isFree(int port) {
        return port < sorts.length && sorts[port] != null;
    }

    /** As {@link Letters#of}. */
    public List<Value[]> letters(
            Component.Profile profile, List<Port> inputs, List<PortAbstraction> looks) {
        List<Integer> open = new ArrayList<>();
        for (int port = 0; port < sorts.length; port++) {
            if (sorts[port] != null && looks.get(port) instanceof Copied) {
                open.add(port);
            }
        }
        if (open.isEmpty()) {
            return Letters.of(profile, inputs, looks);
        }
        Map<Integer, FreshValues> fresh = new HashMap<>();
        for (int port : open) {
            int count = atOnce(sorts[port], profile, inputs, open);
            fresh.computeIfAbsent(
                    sorts[port].number(),
                    sort ->
                            FreshValues.of(
                                    sorts[port], Objects.requireNonNull(held.get(sort)), count));
        }
        List<Value[]> letters =
                Letters.of(
                        profile,
                        inputs,
                        (port, present) ->
                                open.contains(port)
                                        ? samples(inputs.get(port), present, port, fresh)
                                        : MessageClasses.of(
                                                        inputs.get(port), present, looks.get(port))
                                                .samples());
        letters.removeIf(letter -> !isFirst(letter, open, fresh));
        return letters;
    }

    /**
     * A run may compare a message with strangers that it has met on its way: with other ones, when
     * these stand in for them.
     */
    public void copyWhatMeetsStrangers(PortAbstraction[] looks) {
        for (int port = 0; port < sorts.length; port++) {
            if (sorts[port] != null
                    && looks[port] instanceof Compared compared
                    && !known(sorts[port]).containsAll(compared.values())) {
                looks[port] = new Copied();
            }
        }
    }

    private Set<Value> known(Sort sort) {
        Set<Value> known = new TreeSet<>();
        known.addAll(sort.constants());
        known.addAll(held.get(sort.number()));
        return known;
    }

    /** How many ports may carry a value of a sort at the same time. */
    private int atOnce(
            Sort sort, Component.Profile profile, List<Port> inputs, List<Integer> open) {
        int ports = 0;
        int events = 0;
        for (int port : open) {
            if (sorts[port].number() == sort.number()) {
                boolean event =
                        profile == Component.Profile.EVENT_DRIVEN && !inputs.get(port).latched();
                events += event ? 1 : 0;
                ports += event ? 0 : 1;
            }
        }
        return ports + Math.min(events, 1);
    }

    private List<Value> samples(
            Port port, boolean present, int position, Map<Integer, FreshValues> fresh) {
        Sort sort = sorts[position];
        List<Value> samples = new ArrayList<>();
        if (!present) {
            samples.add(null);
        }
        known(sort).stream()
                .filter(value -> MessageClasses.isIn(port.type(), value))
                .forEach(samples::add);
        samples.addAll(Objects.requireNonNull(fresh.get(sort.number())).in(port.type()));
        return samples;
    }

    /** Of letters that differ only in which stranger is which, the first is enough. */
    private boolean isFirst(Value[] letter, List<Integer> open, Map<Integer, FreshValues> fresh) {
        for (Map.Entry<Integer, FreshValues> each : fresh.entrySet()) {
            List<Value> met = new ArrayList<>();
            for (int port : open) {
                if (sorts[port].number() == each.getKey() && letter[port] != null) {
                    met.add(letter[port]);
                }
            }
            if (!each.getValue().areInOrder(met)) {
                return false;
            }
        }
        return true;
    }
}
