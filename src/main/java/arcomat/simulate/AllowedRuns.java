package arcomat.simulate;

import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Behaviour;
import arcomat.semantics.Behaviour.JointReaction;
import arcomat.semantics.Behaviour.JointStart;
import arcomat.semantics.Behaviour.Prospect;
import arcomat.semantics.Configuration;
import arcomat.semantics.Input;
import arcomat.semantics.Network;
import arcomat.semantics.Sent;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * All runs of a time-synchronous network at once, as a set of worlds (subset construction). What a
 * completion leaves open stays open until somebody reads it; then each value of a small type is
 * tried, and a reader of a larger type is in chaos from there on, which allows too much rather than
 * too little and is reported as vacuous.
 */
final class AllowedRuns {
    /** More worlds than that are not followed. */
    static final int MOST_WORLDS = 10_000;

    private final Network network;
    private final List<Behaviour> behaviours = new ArrayList<>();
    private final boolean[] delayed;
    private final int[] sender;
    private String lastProblem;

    AllowedRuns(Network network) {
        this.network = network;
        delayed = new boolean[network.signals()];
        sender = new int[network.signals()];
        Arrays.fill(sender, -1);
        for (Network.Instance instance : network.instances()) {
            List<Port> outputs = instance.component().outputs();
            for (int i = 0; i < outputs.size(); i++) {
                int signal = instance.outputSignals().get(i);
                delayed[signal] = outputs.get(i).delay() > 0;
                sender[signal] = behaviours.size();
            }
            behaviours.add(Behaviour.of(instance.component(), instance.arguments()));
        }
    }

    /** Whether the messages of a signal come out of a register, known before the slice. */
    boolean isDelayed(int signal) {
        return signal != Network.UNCONNECTED && delayed[signal];
    }

    /** Why the last possibility that could not go on could not. */
    Optional<String> lastProblem() {
        return Optional.ofNullable(lastProblem);
    }

    Set<World> starts() {
        Sent[] silent = new Sent[network.signals()];
        Arrays.fill(silent, Sent.SILENCE);
        List<Possibility> possible = new ArrayList<>();
        possible.add(new Possibility(new World(List.of(), List.of(silent), false)));
        for (int i = 0; i < behaviours.size(); i++) {
            List<Possibility> next = new ArrayList<>();
            for (Possibility before : possible) {
                for (JointStart start : behaviours.get(i).starts()) {
                    Possibility after = before.copy();
                    after.configurations.add(start.configurations());
                    send(after, i, start.output().ports());
                    next.add(after);
                }
            }
            possible = limited(next);
        }
        return worlds(possible);
    }

    /** All ways through a slice, before the outputs are compared with anything. */
    List<Possibility> slice(Collection<World> worlds, Letter letter) {
        List<Possibility> possible = new ArrayList<>();
        for (World world : worlds) {
            Possibility possibility = new Possibility(world);
            for (Network.External external : network.inputs()) {
                List<Value> messages = letter.messages(external.name());
                possibility.visible[external.signal()] = new Sent.Messages(messages);
            }
            possible.add(possibility);
        }
        for (int i = 0; i < behaviours.size(); i++) {
            List<Possibility> next = new ArrayList<>(possible.size());
            for (Possibility possibility : possible) {
                for (Possibility settled : settled(possibility, i)) {
                    react(settled, i, next);
                }
            }
            possible = limited(next);
        }
        return possible;
    }

    static Set<World> worlds(List<Possibility> possible) {
        Set<World> worlds = new LinkedHashSet<>();
        possible.forEach(possibility -> worlds.add(possibility.finish()));
        return worlds;
    }

    private static List<Possibility> limited(List<Possibility> possible) {
        if (possible.size() > MOST_WORLDS) {
            throw new ModelError(
                    "more than " + MOST_WORLDS + " possible runs: the test leaves too much open");
        }
        return possible;
    }

    /** Possibilities in which all that an instance reads is certain, where that can be had. */
    private List<Possibility> settled(Possibility possibility, int instance) {
        List<Possibility> settled = List.of(possibility);
        List<Port> ports = network.instances().get(instance).component().inputs();
        for (int i = 0; i < ports.size(); i++) {
            int signal = network.instances().get(instance).inputSignals().get(i);
            if (signal == Network.UNCONNECTED
                    || possibility.visible[signal] instanceof Sent.Messages) {
                continue;
            }
            Optional<List<Value>> values = SmallTypes.values(ports.get(i).type());
            if (values.isEmpty()) {
                return List.of(lost(possibility, instance));
            }
            settled = guesses(settled, signal, values.get());
        }
        return settled;
    }

    private List<Possibility> guesses(List<Possibility> open, int signal, List<Value> values) {
        List<Possibility> guessed = new ArrayList<>();
        for (Possibility possibility : open) {
            if (possibility.visible[signal] instanceof Sent.Anything) {
                guessed.add(guess(possibility, signal, List.of()));
            }
            values.forEach(value -> guessed.add(guess(possibility, signal, List.of(value))));
        }
        return guessed;
    }

    private Possibility guess(Possibility open, int signal, List<Value> messages) {
        Possibility copy = open.copy();
        copy.vacuous |= isFromChaos(open, signal);
        copy.visible[signal] = new Sent.Messages(messages);
        return copy;
    }

    private Possibility lost(Possibility possibility, int instance) {
        Possibility copy = possibility.copy();
        List<Configuration> before = copy.configurations.get(instance);
        copy.configurations.set(instance, before.stream().map(c -> Configuration.CHAOS).toList());
        return copy;
    }

    private void react(Possibility before, int instance, List<Possibility> next) {
        Prospect prospect =
                behaviours
                        .get(instance)
                        .prospect(before.configurations.get(instance), input(before, instance));
        prospect.errors().forEach(error -> lastProblem = error.message());
        if (prospect.isContradiction()) {
            lastProblem = "its automata contradict each other";
        }
        List<JointReaction> reactions = prospect.reactions();
        for (JointReaction reaction : reactions) {
            Possibility after = reactions.size() == 1 ? before : before.copy();
            after.configurations.set(instance, reaction.next());
            send(after, instance, reaction.output().ports());
            next.add(after);
        }
    }

    private Input input(Possibility possibility, int instance) {
        List<Integer> signals = network.instances().get(instance).inputSignals();
        Value[] messages = new Value[signals.size()];
        for (int i = 0; i < messages.length; i++) {
            int signal = signals.get(i);
            if (signal != Network.UNCONNECTED
                    && possibility.visible[signal] instanceof Sent.Messages sent
                    && !sent.values().isEmpty()) {
                messages[i] = sent.values().get(0);
            }
        }
        return Input.of(messages);
    }

    private void send(Possibility after, int instance, List<Sent> sent) {
        List<Integer> signals = network.instances().get(instance).outputSignals();
        for (int i = 0; i < sent.size(); i++) {
            int signal = signals.get(i);
            (delayed[signal] ? after.registers : after.visible)[signal] = sent.get(i);
        }
    }

    /** What is seen on an external output. */
    static Sent seen(Possibility possibility, Network.External external) {
        return external.signal() == Network.UNCONNECTED
                ? Sent.SILENCE
                : possibility.visible[external.signal()];
    }

    /**
     * Whether an external output is as expected; a possibility in which only chaos allows it is
     * marked.
     */
    boolean agrees(Possibility possibility, Network.External external, List<Value> expected) {
        Sent sent = seen(possibility, external);
        if (!sent.allows(expected)) {
            return false;
        }
        if (!(sent instanceof Sent.Messages)) {
            possibility.vacuous |= isFromChaos(possibility, external.signal());
        }
        return true;
    }

    private boolean isFromChaos(Possibility possibility, int signal) {
        return sender[signal] >= 0 && possibility.isChaotic(sender[signal], delayed[signal]);
    }

    /** The external outputs by name. */
    Map<String, Network.External> outputs() {
        Map<String, Network.External> outputs = new HashMap<>();
        network.outputs().forEach(external -> outputs.put(external.name(), external));
        return outputs;
    }
}
