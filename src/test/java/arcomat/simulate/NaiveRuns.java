package arcomat.simulate;

import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;

/**
 * Whether a component may do what a test says, by trying every message that anything leaves open
 * when it is sent. Slow and simple: it shares nothing with stream tests but the steps of a
 * component. For small ranges.
 */
public final class NaiveRuns {

    /**
     * A run in the middle of a slice, or between two.
     *
     * @param parts per part its configurations
     * @param visible per signal the message in this slice, null if there is none
     * @param registers per signal the message in the next slice
     */
    private record Run(
            List<List<Configuration>> parts, List<Value> visible, List<Value> registers) {
        boolean isChaotic() {
            return parts.stream().anyMatch(each -> each.contains(Configuration.CHAOS));
        }
    }

    private final StreamTest test;
    private final Network network;
    private final List<ComponentSemantics> behaviours = new ArrayList<>();
    private final Set<Integer> delayed;
    private final boolean withChaos;

    private NaiveRuns(StreamTest test, boolean withChaos) {
        this.test = test;
        this.withChaos = withChaos;
        network = Network.of(test.component(), test.arguments());
        network.instances()
                .forEach(
                        each ->
                                behaviours.add(
                                        ComponentSemantics.of(each.component(), each.arguments())));
        delayed = network.delayed();
    }

    /**
     * Whether some run shows what is expected.
     *
     * @param withChaos whether runs count in which something is in chaos
     */
    public static boolean allow(StreamTest test, boolean withChaos) {
        return new NaiveRuns(test, withChaos).isPossible();
    }

    private boolean isPossible() {
        Set<Run> runs = starts();
        for (int slice = 0; slice < test.inputs().size(); slice++) {
            Set<Run> after = new HashSet<>();
            for (Run run : runs) {
                after(run, test.inputs().get(slice), slice, after);
            }
            runs = after;
        }
        int last = test.inputs().size();
        return runs.stream().anyMatch(run -> shows(run.registers, last, false));
    }

    private Set<Run> starts() {
        List<Value> nothing = Arrays.asList(new Value[network.signals()]);
        Collection<Run> runs = List.of(new Run(List.of(), nothing, nothing));
        for (int part = 0; part < behaviours.size(); part++) {
            Set<Run> longer = new LinkedHashSet<>();
            for (Run run : runs) {
                for (JointStart start : behaviours.get(part).starts()) {
                    List<List<Configuration>> parts = new ArrayList<>(run.parts);
                    parts.add(start.configurations());
                    Run begun = new Run(parts, nothing, run.registers);
                    longer.addAll(sent(begun, part, start.output().ports()));
                }
            }
            runs = longer;
        }
        return new HashSet<>(runs);
    }

    private void after(Run before, Letter letter, int slice, Set<Run> found) {
        List<Value> visible = new ArrayList<>(before.registers);
        for (Network.External input : network.inputs()) {
            visible.set(input.signal(), letter.message(input.name()).orElse(null));
        }
        List<Value> nothing = Arrays.asList(new Value[network.signals()]);
        Collection<Run> runs = List.of(new Run(before.parts, visible, nothing));
        for (int part = 0; part < behaviours.size(); part++) {
            Set<Run> longer = new LinkedHashSet<>();
            for (Run run : runs) {
                Input read = read(run, part);
                for (JointReaction reaction :
                        behaviours.get(part).prospect(run.parts.get(part), read).reactions()) {
                    List<List<Configuration>> parts = new ArrayList<>(run.parts);
                    parts.set(part, reaction.next());
                    Run reacted = new Run(parts, run.visible, run.registers);
                    if (withChaos || !reacted.isChaotic()) {
                        longer.addAll(sent(reacted, part, reaction.output().ports()));
                    }
                }
            }
            runs = longer;
        }
        for (Run run : runs) {
            if (shows(run.visible, slice, true)) {
                found.add(new Run(run.parts, nothing, run.registers));
            }
        }
    }

    private Input read(Run run, int part) {
        return Input.of(
                network.instances().get(part).inputSignals().stream()
                        .map(signal -> signal < 0 ? null : run.visible.get(signal))
                        .toArray(Value[]::new));
    }

    /** Every message that a part may send. */
    private Collection<Run> sent(Run run, int part, List<Sent> sent) {
        Network.Instance instance = network.instances().get(part);
        Collection<Run> runs = List.of(run);
        for (int i = 0; i < sent.size(); i++) {
            int signal = instance.outputSignals().get(i);
            List<Run> longer = new ArrayList<>();
            for (Value value : everything(instance.component().outputs().get(i))) {
                if (sent.get(i).allows(value == null ? List.of() : List.of(value))) {
                    for (Run each : runs) {
                        List<Value> visible = new ArrayList<>(each.visible);
                        List<Value> registers = new ArrayList<>(each.registers);
                        (delayed.contains(signal) ? registers : visible).set(signal, value);
                        longer.add(new Run(each.parts, visible, registers));
                    }
                }
            }
            runs = longer;
        }
        return runs;
    }

    private static List<Value> everything(Port port) {
        Type.IntegerType type = (Type.IntegerType) port.type();
        List<Value> all = new ArrayList<>();
        all.add(null);
        LongStream.rangeClosed(type.low(), type.high())
                .mapToObj(Value.IntegerValue::new)
                .forEach(all::add);
        return all;
    }

    private boolean shows(List<Value> visible, int slice, boolean evaluated) {
        for (Network.External output : network.outputs()) {
            List<List<Value>> stream = test.expected().getOrDefault(output.name(), List.of());
            int signal = output.signal();
            if (slice < stream.size() && (evaluated || delayed.contains(signal))) {
                Value message = signal < 0 ? null : visible.get(signal);
                if (!stream.get(slice).equals(message == null ? List.of() : List.of(message))) {
                    return false;
                }
            }
        }
        return true;
    }
}
