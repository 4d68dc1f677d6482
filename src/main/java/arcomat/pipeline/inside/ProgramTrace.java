package arcomat.pipeline.inside;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Refusal;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.RobotRun;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a program did, slice by slice, told as a run of its model. Where a part is and what it reads
 * is seen in the code; what it does then, the model says: the first transition that is enabled, as
 * in the code. A slice of one that events drive is all that it handles in a cycle.
 */
final class ProgramTrace {
    private final Component whole;
    private final Network network;
    private final Signals signals;
    private final List<Network.External> between = new ArrayList<>();
    private final List<Trace.Step> steps = new ArrayList<>();
    private final List<Long> times = new ArrayList<>();
    private List<Trace.Activity> activities = new ArrayList<>();

    ProgramTrace(Component whole, Network network) {
        this.whole = whole;
        this.network = network;
        signals = Signals.of(network);
        for (Network.Instance each : network.instances()) {
            List<Port> ports = each.component().outputs();
            for (int i = 0; i < ports.size() && !each.path().isEmpty(); i++) {
                String name = each.path() + "." + ports.get(i).name();
                between.add(new Network.External(name, ports.get(i), each.outputSignals().get(i)));
            }
        }
    }

    /** Before its first step, a part has sent its initial output. */
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
        signals.next();
    }

    /**
     * A part takes its step in the slice, or handles an event.
     *
     * @param nearest the transition that came nearest, where none is enabled
     */
    void step(
            Network.Instance part,
            StepRelation relation,
            Configuration before,
            Input input,
            Optional<Refusal> nearest) {
        signals.read(part, input);
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
            if (output.ports().get(i) instanceof Sent.Messages sent) {
                signals.send(part.outputSignals().get(i), sent.values());
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
        Map<String, List<Value>> messages = new LinkedHashMap<>();
        for (Network.External port : ports) {
            if (port.signal() != Network.UNCONNECTED) {
                messages.put(port.name(), signals.shown(port.signal()));
            }
        }
        return new Letter(messages);
    }

    /** The run so far. */
    RobotRun run(String robot) {
        finish();
        return new RobotRun(robot, new Trace(whole, steps, Optional.empty()), times);
    }
}
