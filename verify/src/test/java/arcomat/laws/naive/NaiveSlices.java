package arcomat.laws.naive;

import arcomat.laws.naive.NaiveAutomata.Place;
import arcomat.laws.naive.NaiveAutomata.Step;
import arcomat.laws.naive.NaiveAutomata.Steps;
import arcomat.laws.naive.NaiveNetwork.Atom;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Slice by slice: what has a delay is visible in the next slice, everything else at once. */
final class NaiveSlices implements NaiveBehaviour {
    private static final int MOST_WAYS = 150;

    private final NaiveNetwork network;
    private final List<Value> pool;
    private final boolean writtenOut;
    private final Set<String> late;
    private final Set<String> seen;

    NaiveSlices(NaiveNetwork network, List<Value> pool, boolean writtenOut) {
        this.network = network;
        this.pool = pool;
        this.writtenOut = writtenOut || network.atoms().size() > 1;
        this.late = network.late();
        this.seen = network.seen();
    }

    /** The parts that have reacted, and what is on the signals now and in the next slice. */
    private record Way(List<List<Place>> parts, Map<String, Slot> now, Map<String, Slot> next) {
        Way with(Atom atom, Port port, Slot slot, boolean isLate) {
            Map<String, Slot> signals = new HashMap<>(isLate ? next : now);
            signals.put(atom.signal(port), slot);
            return isLate ? new Way(parts, now, signals) : new Way(parts, signals, next);
        }
    }

    @Override
    public Component component() {
        return network.whole();
    }

    @Override
    public Moves starts() {
        List<Way> ways = List.of(new Way(List.of(), Map.of(), Map.of()));
        for (Atom atom : network.atoms()) {
            List<Way> longer = new ArrayList<>();
            for (Way way : ways) {
                for (Step step : atom.automata().starts()) {
                    longer.addAll(after(way, atom, step, true));
                }
            }
            ways = longer;
        }
        Set<Move> starts = new HashSet<>();
        ways.forEach(way -> starts.add(new Move(Map.of(), new State(way.parts, way.next))));
        return new Moves(starts, false);
    }

    @Override
    public Moves moves(State before, Map<String, Value> input) {
        Map<String, Slot> now = new HashMap<>(before.kept());
        input.forEach((port, message) -> now.put("." + port, Slot.of(message)));
        List<Way> ways = List.of(new Way(List.of(), now, Map.of()));
        boolean error = false;
        for (int i = 0; i < network.atoms().size(); i++) {
            Atom atom = network.atoms().get(i);
            List<Way> longer = new ArrayList<>();
            for (Way way : ways) {
                Steps steps =
                        atom.automata().steps(before.parts().get(i), read(atom, way.now), false);
                error |= steps.error();
                steps.steps().forEach(step -> longer.addAll(after(way, atom, step, false)));
            }
            ways = longer;
            if (ways.size() > MOST_WAYS) {
                throw new NaiveComparison.TooMuch();
            }
        }
        Set<Move> moves = new HashSet<>();
        ways.forEach(way -> moves.add(new Move(shown(way.now), new State(way.parts, way.next))));
        return new Moves(moves, error);
    }

    private static Map<String, Value> read(Atom atom, Map<String, Slot> now) {
        Map<String, Value> messages = new HashMap<>();
        atom.inputs()
                .forEach(
                        (port, signal) ->
                                messages.put(
                                        port, now.getOrDefault(signal, Slot.SILENCE).message()));
        return messages;
    }

    /** What is left open becomes one message, whoever reads it. */
    private List<Way> after(Way way, Atom atom, Step step, boolean starts) {
        List<List<Place>> parts = new ArrayList<>(way.parts);
        parts.add(step.places());
        List<Way> ways = List.of(new Way(parts, way.now, way.next));
        for (Port port : atom.ports()) {
            boolean isLate = port.delay() == 1;
            if ((isLate || !starts) && seen.contains(atom.signal(port))) {
                Slot slot = step.outputs().get(port.name());
                List<Way> longer = new ArrayList<>();
                for (Slot each : writtenOut ? slot.writtenOut(port, pool) : List.of(slot)) {
                    ways.forEach(w -> longer.add(w.with(atom, port, each, isLate)));
                }
                ways = longer;
            }
        }
        if (ways.size() > MOST_WAYS) {
            throw new NaiveComparison.TooMuch();
        }
        return ways;
    }

    private Map<String, Slot> shown(Map<String, Slot> now) {
        Map<String, Slot> shown = new LinkedHashMap<>();
        for (Port port : component().outputs()) {
            if (!isLate(port.name())) {
                String signal = network.outputs().getOrDefault(port.name(), "");
                shown.put(port.name(), now.getOrDefault(signal, Slot.SILENCE));
            }
        }
        return shown;
    }

    @Override
    public boolean isLate(String output) {
        return late.contains(network.outputs().get(output));
    }

    @Override
    public boolean isConnected(String output) {
        return network.outputs().containsKey(output);
    }

    @Override
    public Slot due(State state, String output) {
        return isConnected(output)
                ? state.kept().getOrDefault(network.outputs().get(output), Slot.SILENCE)
                : Slot.SILENCE;
    }

    @Override
    public boolean isAtOnce(String input, String output) {
        return network.atOnce(input).contains(network.outputs().get(output));
    }
}
