package arcomat.simulate.run;

import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The time-synchronous engine: all instances, slice by slice, in schedule order. */
public final class Slices implements Interpreter.Engine {
    private final Network network;
    private final List<Actor> actors;
    private final Surroundings surroundings;
    private final List<Network.External> heard;

    /** Per signal the message that is visible in the slice, or null. */
    private final Value[] visible;

    /** Per signal with delay 1 the message of the next slice, or null. */
    private final Value[] registers;

    private final Set<Integer> delayed;
    private final boolean[] isDelayed;
    private boolean started;

    /**
     * @param heard ports of parts that are told of
     */
    Slices(Network network, List<Actor> actors, List<Network.External> heard) {
        this.network = network;
        this.actors = actors;
        this.heard = heard;
        this.surroundings = new Surroundings(network);
        this.visible = new Value[network.signals()];
        this.registers = new Value[network.signals()];
        this.delayed = network.delayed();
        this.isDelayed = new boolean[network.signals()];
        delayed.forEach(signal -> isDelayed[signal] = true);
    }

    @Override
    public Trace.Step step(Letter input, int number) {
        if (!started) {
            actors.forEach(actor -> send(actor.instance(), actor.start()));
            delayed.forEach(signal -> visible[signal] = registers[signal]);
            started = true;
        }
        read(input);
        List<Trace.Activity> activities = new ArrayList<>(actors.size());
        for (Actor actor : actors) {
            send(actor.instance(), react(actor, number, activities));
        }
        Trace.Step step =
                new Trace.Step(number, input, shown(network.outputs()), activities, shown(heard));
        for (int signal : delayed) {
            visible[signal] = registers[signal];
        }
        return step;
    }

    private void read(Letter input) {
        surroundings.requireSlice(input);
        for (Network.External external : network.inputs()) {
            List<Value> messages = input.messages(external.name());
            visible[external.signal()] = messages.isEmpty() ? null : messages.get(0);
        }
    }

    private List<List<Value>> react(Actor actor, int number, List<Trace.Activity> activities) {
        List<Integer> signals = actor.instance().inputSignals();
        Value[] messages = new Value[signals.size()];
        for (int i = 0; i < messages.length; i++) {
            int signal = signals.get(i);
            messages[i] = signal == Network.UNCONNECTED ? null : visible[signal];
        }
        return actor.react(Input.of(messages), number, activities);
    }

    private void send(Network.Instance instance, List<List<Value>> messages) {
        for (int i = 0; i < messages.size(); i++) {
            int signal = instance.outputSignals().get(i);
            Value message = messages.get(i).isEmpty() ? null : messages.get(i).get(0);
            (isDelayed[signal] ? registers : visible)[signal] = message;
        }
    }

    private Letter shown(List<Network.External> outputs) {
        Map<String, Value> messages = new LinkedHashMap<>();
        for (Network.External external : outputs) {
            int signal = external.signal();
            if (signal != Network.UNCONNECTED && visible[signal] != null) {
                messages.put(external.name(), visible[signal]);
            }
        }
        return Letter.of(messages);
    }

    /** What was sent a slice ago is seen, whatever goes wrong in this one. */
    @Override
    public Trace.End end(Letter input) {
        List<Network.External> late =
                network.outputs().stream().filter(each -> delayed.contains(each.signal())).toList();
        return new Trace.End(input, shown(late));
    }
}
