package arcomat.analysis.search.reduction;

import arcomat.analysis.search.reduction.PartWiring.Reader;
import arcomat.semantics.network.Network;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * Parts of a network in each other's places, with all that follows from their wires: each part in
 * the place of an equal one, each signal in that of one that is sent and read alike.
 */
final class WiringMap {
    /** One part, or signal, that is put in the place of another. */
    private record Put(boolean part, int from, int to, boolean first) {}

    private final PartWiring wires;

    /** Per part whose place it takes. */
    final int[] parts;

    final int[] signals;

    /** The parts that move because the first one does. */
    final BitSet withFirst = new BitSet();

    private final Deque<Put> open = new ArrayDeque<>();

    private WiringMap(PartWiring wires) {
        this.wires = wires;
        parts = new int[wires.network.instances().size()];
        signals = new int[wires.network.signals()];
        Arrays.fill(parts, -1);
        Arrays.fill(signals, -1);
    }

    /** A part goes to a place, and all others where they then have to be. */
    static Optional<WiringMap> moving(PartWiring wires, int part, int place) {
        WiringMap map = new WiringMap(wires);
        map.open.add(new Put(true, part, place, true));
        return map.close() ? Optional.of(map) : Optional.empty();
    }

    /** Two parts change places, each with those that are its own. */
    static Optional<WiringMap> swapping(PartWiring wires, int part, int other) {
        WiringMap map = new WiringMap(wires);
        map.open.add(new Put(true, part, other, true));
        map.open.add(new Put(true, other, part, false));
        return map.close() ? Optional.of(map) : Optional.empty();
    }

    private boolean close() {
        while (!open.isEmpty()) {
            Put put = open.remove();
            if (put.part ? !putPart(put) : !putSignal(put)) {
                return false;
            }
        }
        return isComplete(parts) && isComplete(signals) && isSymmetry();
    }

    private boolean putPart(Put put) {
        if (parts[put.from] >= 0) {
            return parts[put.from] == put.to;
        }
        if (!wires.areEqual(put.from, put.to)) {
            return false;
        }
        parts[put.from] = put.to;
        if (put.first && put.from != put.to) {
            withFirst.set(put.from);
        }
        List<Integer> outputs = wires.outputs(put.from);
        for (int port = 0; port < outputs.size(); port++) {
            int to = wires.outputs(put.to).get(port);
            open.add(new Put(false, outputs.get(port), to, put.first));
        }
        List<Integer> inputs = wires.inputs(put.from);
        for (int port = 0; port < inputs.size() && put.from != put.to; port++) {
            int from = inputs.get(port);
            int to = wires.inputs(put.to).get(port);
            if (from < 0 != to < 0) {
                return false;
            }
            if (from >= 0) {
                open.add(new Put(false, from, to, put.first));
            }
        }
        return true;
    }

    private boolean putSignal(Put put) {
        if (signals[put.from] >= 0) {
            return signals[put.from] == put.to;
        }
        signals[put.from] = put.to;
        int sender = wires.senders[put.from];
        if (sender < 0 || wires.senders[put.to] < 0) {
            return put.from == put.to;
        }
        open.add(new Put(true, sender, wires.senders[put.to], put.first));
        for (Reader reader : wires.readers.get(put.from)) {
            int same = wires.only(put.from, reader);
            int other = wires.only(put.to, reader);
            if (same >= 0 && other >= 0) {
                open.add(new Put(true, same, other, put.first));
            }
        }
        return true;
    }

    /** What has not been put anywhere stays; empty where its place is taken. */
    private static boolean isComplete(int[] places) {
        BitSet taken = new BitSet();
        for (int i = 0; i < places.length; i++) {
            places[i] = places[i] < 0 ? i : places[i];
            if (taken.get(places[i])) {
                return false;
            }
            taken.set(places[i]);
        }
        return true;
    }

    /** Looks at everything again, whatever led to it. */
    private boolean isSymmetry() {
        for (int signal : wires.fixed) {
            if (signals[signal] != signal) {
                return false;
            }
        }
        for (int part = 0; part < parts.length; part++) {
            boolean alike =
                    wires.areEqual(part, parts[part])
                            && moved(wires.outputs(part)).equals(wires.outputs(parts[part]))
                            && (moved(wires.inputs(part)).equals(wires.inputs(parts[part]))
                                    || part == parts[part]
                                            && wires.ignoresOrder(part, moved(wires.inputs(part))));
            if (!alike) {
                return false;
            }
        }
        return true;
    }

    private List<Integer> moved(List<Integer> all) {
        return all.stream().map(s -> s == Network.UNCONNECTED ? s : signals[s]).toList();
    }
}
