package arcomat.pipeline.inside;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Refusal;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.report.run.RobotRun;
import arcomat.rt.ModelError;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What a program did, slice by slice, told as a run of its model. Where a part is and what it reads
 * is seen in the code; what it does then, the model says: the first transition that is enabled, as
 * in the code.
 */
final class ProgramTrace {
    private final Component whole;
    private final Network network;
    private final Set<Integer> delayed;
    private final List<Network.External> between = new ArrayList<>();
    private final List<Trace.Step> steps = new ArrayList<>();
    private final List<Long> times = new ArrayList<>();
    private List<Trace.Activity> activities = new ArrayList<>();

    /** Per signal the message that is visible in the slice, or null. */
    private Value[] visible;

    /** Per signal with delay the message of the next slice, or null. */
    private Value[] registers;

    ProgramTrace(Component whole, Network network) {
        this.whole = whole;
        this.network = network;
        delayed = network.delayed();
        visible = new Value[network.signals()];
        registers = new Value[network.signals()];
        for (Network.Instance each : network.instances()) {
            List<Port> ports = each.component().outputs();
            for (int i = 0; i < ports.size() && !each.path().isEmpty(); i++) {
                String name = each.path() + "." + ports.get(i).name();
                between.add(new Network.External(name, ports.get(i), each.outputSignals().get(i)));
            }
        }
    }

    /** Before its first slice, a part has sent its initial output. */
    void start(Network.Instance part, StepRelation relation) {
        if (!relation.starts().isEmpty()) {
            send(part, relation.starts().get(0).output());
        }
    }

    /**
     * A slice begins.
     *
     * @param time in milliseconds
     */
    void begin(long time) {
        finish();
        times.add(time);
        visible = registers;
        registers = new Value[network.signals()];
    }

    /**
     * A part takes its step in the slice.
     *
     * @param nearest the transition that came nearest, where none is enabled
     */
    void step(
            Network.Instance part,
            StepRelation relation,
            Configuration before,
            Input input,
            Optional<Refusal> nearest) {
        for (int i = 0; i < part.inputSignals().size(); i++) {
            int signal = part.inputSignals().get(i);
            if (signal != Network.UNCONNECTED) {
                visible[signal] = input.message(i).orElse(null);
            }
        }
        try {
            Reaction reaction =
                    relation.firstEnabled(before, input)
                            .map(taken -> relation.take(taken, before, input))
                            .orElseGet(() -> relation.complete(before));
            send(part, reaction.output());
            activities.add(activity(part, relation.automaton(), before, reaction, nearest));
        } catch (ModelError error) {
            // The program is about to say so itself.
        }
    }

    private void send(Network.Instance part, Output output) {
        for (int i = 0; i < output.ports().size(); i++) {
            int signal = part.outputSignals().get(i);
            if (output.ports().get(i) instanceof Sent.Messages sent) {
                Value message = sent.values().isEmpty() ? null : sent.values().get(0);
                (delayed.contains(signal) ? registers : visible)[signal] = message;
            }
        }
    }

    private static Trace.Activity activity(
            Network.Instance part,
            Automaton automaton,
            Configuration before,
            Reaction reaction,
            Optional<Refusal> nearest) {
        Configuration after = reaction.next().isState() ? reaction.next() : before;
        Map<String, Value> variables = new LinkedHashMap<>();
        for (int i = 0; i < automaton.variables().size(); i++) {
            variables.put(automaton.variables().get(i).name(), after.variables().get(i));
        }
        return new Trace.Activity(
                part.path(),
                automaton.name(),
                automaton.states().get(before.state()),
                automaton.states().get(after.state()),
                reaction.cause(),
                variables,
                nearest);
    }

    private void finish() {
        if (times.size() > steps.size()) {
            steps.add(
                    new Trace.Step(
                            steps.size(),
                            shown(network.inputs()),
                            shown(network.outputs()),
                            activities,
                            shown(between)));
            activities = new ArrayList<>();
        }
    }

    private Letter shown(List<Network.External> ports) {
        Map<String, Value> messages = new LinkedHashMap<>();
        for (Network.External port : ports) {
            Value message = port.signal() == Network.UNCONNECTED ? null : visible[port.signal()];
            if (message != null) {
                messages.put(port.name(), message);
            }
        }
        return Letter.of(messages);
    }

    /** The run so far. */
    RobotRun run(String robot) {
        finish();
        return new RobotRun(robot, new Trace(whole, steps, Optional.empty()), times);
    }
}
