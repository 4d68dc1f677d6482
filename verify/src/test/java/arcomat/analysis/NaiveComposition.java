package arcomat.analysis;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The parts of a composition, one after the other, with every message written out: nothing stays
 * open from one part to the next. For ports of enums and Booleans.
 */
public final class NaiveComposition implements NaiveMachine {

    /**
     * Between two slices.
     *
     * @param parts per part the configurations of its automata; empty after an error
     * @param registers per signal the message of the next slice, null if there is none
     */
    public record State(List<List<Configuration>> parts, List<Value> registers) {}

    /** A way through a slice. */
    public record Move(Map<String, Value> output, State next) {}

    private static final Move FAILURE = new Move(ERROR, new State(List.of(), List.of()));

    private final Network network;
    private final List<ComponentSemantics> behaviours = new ArrayList<>();
    private final Set<Integer> delayed = new HashSet<>();
    private final Map<State, Map<Map<String, Value>, Set<Move>>> known = new HashMap<>();

    public NaiveComposition(Component component, List<Value> arguments) {
        network = Network.of(component, arguments);
        for (Network.Instance part : network.instances()) {
            behaviours.add(ComponentSemantics.of(part.component(), part.arguments()));
            List<Port> outputs = part.component().outputs();
            for (int i = 0; i < outputs.size(); i++) {
                if (outputs.get(i).delay() > 0) {
                    delayed.add(part.outputSignals().get(i));
                }
            }
        }
    }

    @Override
    public Component component() {
        return network.component();
    }

    /** Whether what is seen on a port of the whole comes out of a register. */
    public boolean isDelayed(String output) {
        return network.outputs().stream()
                .anyMatch(each -> each.name().equals(output) && delayed.contains(each.signal()));
    }

    @Override
    public Set<Object> starts(Map<String, Value> output) {
        return agreeing(starts(), output);
    }

    @Override
    public Set<Object> after(Object before, Map<String, Value> input, Map<String, Value> output) {
        return agreeing(moves((State) before, input), output);
    }

    private static Set<Object> agreeing(Set<Move> moves, Map<String, Value> output) {
        Set<Object> found = new HashSet<>();
        for (Move move : moves) {
            boolean same = (move.output == ERROR) == (output == ERROR);
            if (same && move.output.entrySet().containsAll(output.entrySet())) {
                found.add(move.next);
            }
        }
        return found;
    }

    public Set<Move> starts() {
        List<Way> ways = List.of(new Way(network.signals()));
        for (int part = 0; part < behaviours.size(); part++) {
            List<Way> longer = new ArrayList<>();
            for (Way way : ways) {
                for (JointStart start : behaviours.get(part).starts()) {
                    Way copy = new Way(way);
                    copy.after.add(start.configurations());
                    send(copy, part, start.output().ports(), longer);
                }
            }
            ways = longer;
        }
        return moves(ways);
    }

    public Set<Move> moves(State before, Map<String, Value> input) {
        return known.computeIfAbsent(before, key -> new HashMap<>())
                .computeIfAbsent(input, key -> computed(before, input));
    }

    private Set<Move> computed(State before, Map<String, Value> input) {
        if (before.parts.isEmpty()) {
            return Set.of();
        }
        Way beginning = new Way(network.signals());
        delayed.forEach(signal -> beginning.visible[signal] = before.registers.get(signal));
        network.inputs().forEach(e -> beginning.visible[e.signal()] = input.get(e.name()));
        List<Way> ways = List.of(beginning);
        for (int part = 0; part < behaviours.size(); part++) {
            List<Way> longer = new ArrayList<>();
            for (Way way : ways) {
                if (way.isOver()) {
                    longer.add(way);
                } else {
                    react(way, part, before.parts.get(part), longer);
                }
            }
            ways = longer;
        }
        return moves(ways);
    }

    private void react(Way way, int part, List<Configuration> before, List<Way> found) {
        Value[] read =
                network.instances().get(part).inputSignals().stream()
                        .map(signal -> signal < 0 ? null : way.visible[signal])
                        .toArray(Value[]::new);
        Prospect prospect = behaviours.get(part).prospect(before, Input.of(read));
        if (!prospect.errors().isEmpty()) {
            Way copy = new Way(way);
            copy.after.add(List.of(Configuration.ERROR));
            found.add(copy);
        }
        for (JointReaction reaction : prospect.reactions()) {
            Way copy = new Way(way);
            copy.after.add(reaction.next());
            send(copy, part, reaction.output().ports(), found);
        }
    }

    /** Every letter that a part may send. */
    private void send(Way way, int part, List<Sent> sent, List<Way> found) {
        List<Way> ways = List.of(way);
        Network.Instance instance = network.instances().get(part);
        for (int i = 0; i < sent.size(); i++) {
            int signal = instance.outputSignals().get(i);
            List<Way> longer = new ArrayList<>();
            for (Value value : everything(instance.component().outputs().get(i))) {
                if (sent.get(i).allows(value == null ? List.of() : List.of(value))) {
                    for (Way each : ways) {
                        Way copy = new Way(each);
                        (delayed.contains(signal) ? copy.registers : copy.visible)[signal] = value;
                        longer.add(copy);
                    }
                }
            }
            ways = longer;
        }
        found.addAll(ways);
    }

    private static List<Value> everything(Port port) {
        List<Value> all = new ArrayList<>();
        all.add(null);
        NaiveInclusion.values(port).stream().filter(v -> v != null).forEach(all::add);
        return all;
    }

    private Set<Move> moves(List<Way> ways) {
        Set<Move> moves = new LinkedHashSet<>();
        for (Way way : ways) {
            List<Value> registers = Arrays.asList(way.registers);
            moves.add(
                    way.isOver()
                            ? FAILURE
                            : new Move(output(way), new State(way.after, registers)));
        }
        return moves;
    }

    private Map<String, Value> output(Way way) {
        Map<String, Value> output = new LinkedHashMap<>();
        for (Network.External port : network.outputs()) {
            int signal = port.signal();
            Value[] messages = delayed.contains(signal) ? way.registers : way.visible;
            output.put(port.name(), signal < 0 ? null : messages[signal]);
        }
        return output;
    }

    /** A way through a slice, as far as the parts have reacted. */
    private static final class Way {
        final List<List<Configuration>> after;
        final Value[] visible;
        final Value[] registers;

        Way(int signals) {
            after = new ArrayList<>();
            visible = new Value[signals];
            registers = new Value[signals];
        }

        Way(Way other) {
            after = new ArrayList<>(other.after);
            visible = other.visible.clone();
            registers = other.registers.clone();
        }

        boolean isOver() {
            return after.stream().anyMatch(c -> c.contains(Configuration.ERROR));
        }
    }
}
