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

/** Event by event: all that one causes is worked off, part after part, before the next one. */
final class NaiveEvents implements NaiveBehaviour {
    /** Longer runs circle. */
    private static final int LONGEST = 60;

    private final NaiveNetwork network;
    private final List<Value> pool;
    private final boolean writtenOut;

    NaiveEvents(NaiveNetwork network, List<Value> pool, boolean writtenOut) {
        this.network = network;
        this.pool = pool;
        this.writtenOut = writtenOut;
    }

    private record Event(int atom, String port, Value message) {}

    /** What is left to do, and what has been sent by signal. */
    private record Way(
            List<List<Place>> parts,
            Map<String, Slot> latched,
            List<Event> waiting,
            Map<String, Slot> sent) {}

    @Override
    public Component component() {
        return network.whole();
    }

    @Override
    public Moves starts() {
        List<Way> ways = List.of(new Way(List.of(), Map.of(), List.of(), Map.of()));
        for (int atom = 0; atom < network.atoms().size(); atom++) {
            List<Way> longer = new ArrayList<>();
            for (Way way : ways) {
                if (way == null) {
                    longer.add(null);
                    continue;
                }
                for (Step step : network.atoms().get(atom).automata().starts()) {
                    List<List<Place>> parts = new ArrayList<>(way.parts);
                    parts.add(step.places());
                    longer.addAll(
                            sent(new Way(parts, way.latched, way.waiting, way.sent), atom, step));
                }
            }
            ways = longer;
        }
        return workedOff(ways);
    }

    @Override
    public Moves moves(State before, Map<String, Value> input) {
        List<Way> ways = List.of(new Way(before.parts(), before.kept(), List.of(), Map.of()));
        boolean unknown = true;
        for (Map.Entry<String, Value> each : input.entrySet()) {
            if (each.getValue() != null) {
                unknown &= component().port(each.getKey()).map(Port::latched).orElse(true);
                ways =
                        ways.stream()
                                .map(
                                        w ->
                                                w == null
                                                        ? null
                                                        : delivered(
                                                                w,
                                                                "." + each.getKey(),
                                                                each.getValue()))
                                .toList();
            }
        }
        if (unknown && network.atoms().get(0).path().equals("<")) {
            return unknown(before, ways);
        }
        return workedOff(ways);
    }

    /** An event on a port that a component does not have: no transition handles it. */
    private Moves unknown(State before, List<Way> delivered) {
        Steps steps =
                network.atoms().get(0).automata().steps(before.parts().get(0), Map.of(), true);
        List<Way> ways = new ArrayList<>();
        for (Step step : steps.steps()) {
            Map<String, Slot> latched = delivered.get(0).latched;
            Way way = new Way(List.of(step.places()), latched, List.of(), Map.of());
            ways.addAll(sent(way, 0, step));
        }
        return new Moves(workedOff(ways).moves(), steps.error());
    }

    /** Each part takes one event after the other, in turns, until none is left. */
    private Moves workedOff(List<Way> begun) {
        Set<Move> moves = new HashSet<>();
        boolean[] error = {false};
        for (Way way : begun) {
            if (way == null) {
                error[0] = true;
            } else {
                workOff(way, 0, 0, moves, error);
            }
        }
        return new Moves(moves, error[0]);
    }

    private void workOff(Way way, int turn, int reactions, Set<Move> moves, boolean[] error) {
        if (way.waiting.isEmpty()) {
            moves.add(new Move(shown(way.sent), new State(way.parts, way.latched)));
            return;
        }
        int atom = turn;
        while (!isWaiting(way, atom)) {
            atom = (atom + 1) % network.atoms().size();
        }
        if (reactions > LONGEST) {
            error[0] = true;
            return;
        }
        List<Event> waiting = new ArrayList<>(way.waiting);
        int own = atom;
        Event event = waiting.stream().filter(e -> e.atom == own).findFirst().orElseThrow();
        waiting.remove(event);
        NaiveAutomata automata = network.atoms().get(atom).automata();
        Map<String, Value> read = new HashMap<>();
        for (Port port : automata.component().inputs()) {
            Slot kept = way.latched.get(key(atom, port.name()));
            read.put(port.name(), kept == null ? null : kept.message());
        }
        read.put(event.port, event.message);
        Steps steps = automata.steps(way.parts.get(atom), read, false);
        error[0] |= steps.error();
        for (Step step : steps.steps()) {
            List<List<Place>> parts = new ArrayList<>(way.parts);
            parts.set(atom, step.places());
            for (Way next : sent(new Way(parts, way.latched, waiting, way.sent), atom, step)) {
                if (next == null) {
                    error[0] = true;
                } else {
                    workOff(next, (atom + 1) % network.atoms().size(), reactions + 1, moves, error);
                }
            }
        }
    }

    private static boolean isWaiting(Way way, int atom) {
        return way.waiting.stream().anyMatch(event -> event.atom == atom);
    }

    private static String key(int atom, String port) {
        return atom + "." + port;
    }

    /** Null is a queue that overflows. */
    private List<Way> sent(Way before, int atom, Step step) {
        List<Way> ways = List.of(before);
        Atom sender = network.atoms().get(atom);
        for (Port port : sender.ports()) {
            String signal = sender.signal(port);
            Slot slot = step.outputs().get(port.name());
            List<Way> longer = new ArrayList<>();
            for (Way way : ways) {
                for (Slot each : decided(slot, port, signal)) {
                    longer.add(sent(way, signal, each));
                }
            }
            ways = longer;
        }
        return ways;
    }

    /** What somebody inside reads is one message or another. */
    private List<Slot> decided(Slot slot, Port port, String signal) {
        boolean read =
                network.atoms().stream().anyMatch(atom -> atom.inputs().containsValue(signal));
        return writtenOut || read ? slot.writtenOut(port, pool) : List.of(slot);
    }

    /** What is left open once stays open, whatever is sent before or after it. */
    private Way sent(Way way, String signal, Slot slot) {
        if (way == null) {
            return null;
        }
        Map<String, Slot> sent = new HashMap<>(way.sent);
        Slot before = sent.getOrDefault(signal, Slot.SILENCE);
        List<Value> all = new ArrayList<>(before.messages());
        all.addAll(slot.messages());
        sent.put(signal, slot.isOpen() ? slot : before.isOpen() ? before : Slot.just(all));
        Way next = new Way(way.parts, way.latched, way.waiting, sent);
        for (Value message : slot.messages()) {
            next = next == null ? null : delivered(next, signal, message);
        }
        return next;
    }

    private Way delivered(Way way, String signal, Value message) {
        Map<String, Slot> latched = new HashMap<>(way.latched);
        List<Event> waiting = new ArrayList<>(way.waiting);
        for (int atom = 0; atom < network.atoms().size(); atom++) {
            Component part = network.atoms().get(atom).automata().component();
            for (Port port : part.inputs()) {
                if (signal.equals(network.atoms().get(atom).inputs().get(port.name()))) {
                    if (port.latched()) {
                        latched.put(key(atom, port.name()), Slot.of(message));
                    } else {
                        waiting.add(new Event(atom, port.name(), message));
                        int own = atom;
                        if (waiting.stream().filter(e -> e.atom == own).count()
                                > part.queueCapacity()) {
                            return null;
                        }
                    }
                }
            }
        }
        Map<String, Slot> sent = way.sent;
        if (signal.lastIndexOf('.') == 0 && network.outputs().containsValue(signal)) {
            sent = new HashMap<>(sent);
            sent.put(signal, Slot.of(message));
        }
        return new Way(way.parts, latched, waiting, sent);
    }

    private Map<String, Slot> shown(Map<String, Slot> sent) {
        Map<String, Slot> shown = new LinkedHashMap<>();
        for (Port port : component().outputs()) {
            String signal = network.outputs().getOrDefault(port.name(), "");
            shown.put(port.name(), sent.getOrDefault(signal, Slot.SILENCE));
        }
        return shown;
    }

    @Override
    public boolean isLate(String output) {
        return false;
    }

    @Override
    public boolean isConnected(String output) {
        return network.outputs().containsKey(output);
    }

    @Override
    public Slot due(State state, String output) {
        return Slot.SILENCE;
    }

    @Override
    public boolean isAtOnce(String input, String output) {
        return true;
    }
}
