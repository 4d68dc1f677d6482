package arcomat.analysis.search.packed;

import arcomat.analysis.search.IntKey;
import arcomat.analysis.search.Numbering;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Unseen;
import arcomat.semantics.value.MessageClasses;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * What a part does, in numbers: of its configurations, and of what is on the signals. Each row is
 * computed once, for a configuration and for messages of which it cannot tell others apart.
 */
final class PartOutcomes {
    /** In place of the next configuration, where the run ends. */
    static final int END = -1;

    /**
     * The outcomes, one behind the other: the next configuration, then what is sent by output port.
     * Ends of the run come first, as the unfolding has them.
     */
    record Row(int[] numbers) {}

    private final ComponentSemantics behaviour;
    private final List<Numbering<Sent>> inputs;
    private final List<Numbering<Sent>> outputs;
    private final Runnable between;
    private final BooleanSupplier alike;
    private final Numbering<List<Configuration>> configurations = new Numbering<>();
    private final List<List<PortAbstraction>> looks = new ArrayList<>();
    private final List<int[][]> kinds = new ArrayList<>();
    private final Map<IntKey, Row> known = new HashMap<>();

    /**
     * @param inputs what is on each input port, in numbers
     * @param outputs what is on each output port, in numbers
     * @param between called before what may take long; may throw to give up
     * @param alike whether messages that look alike are one
     */
    PartOutcomes(
            ComponentSemantics behaviour,
            List<Numbering<Sent>> inputs,
            List<Numbering<Sent>> outputs,
            Runnable between,
            BooleanSupplier alike) {
        this.behaviour = behaviour;
        this.inputs = inputs;
        this.outputs = outputs;
        this.between = between;
        this.alike = alike;
    }

    /** The number of a configuration; they are numbered as they come. */
    int number(List<Configuration> configuration) {
        int number = configurations.number(configuration);
        if (number == looks.size()) {
            look(configuration);
        }
        return number;
    }

    private void look(List<Configuration> configuration) {
        looks.add(
                configuration.contains(Configuration.ERROR)
                        ? InputAbstraction.none(inputs.size()).looks()
                        : behaviour.abstraction(configuration).looks());
        int[][] ofPorts = new int[inputs.size()][];
        Arrays.fill(ofPorts, new int[0]);
        kinds.add(ofPorts);
    }

    List<Configuration> configuration(int number) {
        return configurations.get(number);
    }

    /** How many configurations have been met. */
    int size() {
        return configurations.size();
    }

    /** How an input port is looked at. */
    PortAbstraction look(int configuration, int port) {
        return looks.get(configuration).get(port);
    }

    /**
     * A number below that of the messages on a signal, the same for messages that a configuration
     * cannot tell apart.
     */
    int kind(int configuration, int port, int message) {
        int[] ofMessages = kinds.get(configuration)[port];
        if (message >= ofMessages.length) {
            ofMessages = kinds(looks.get(configuration).get(port), port);
            kinds.get(configuration)[port] = ofMessages;
        }
        return ofMessages[message];
    }

    /** As far as they are known, by input port and message. */
    int[][] kinds(int configuration) {
        return kinds.get(configuration);
    }

    private int[] kinds(PortAbstraction look, int port) {
        Numbering<Sent> messages = inputs.get(port);
        Port read = behaviour.component().inputs().get(port);
        Numbering<Integer> classes = new Numbering<>();
        int[] all = new int[messages.size()];
        for (int i = 0; i < all.length; i++) {
            if (!isCoarse(look) || !alike.getAsBoolean()) {
                all[i] = i;
            } else {
                @Nullable Value message = value(messages.get(i));
                all[i] = classes.number(MessageClasses.of(read, false, look).of(message));
            }
        }
        return all;
    }

    private static boolean isCoarse(PortAbstraction look) {
        return look instanceof Unseen || look instanceof Compared;
    }

    private static @Nullable Value value(Sent sent) {
        return sent instanceof Sent.Messages messages && !messages.values().isEmpty()
                ? messages.values().get(0)
                : null;
    }

    /**
     * @param messages numbers by input port; -1 where nothing is connected
     */
    Row row(int configuration, int[] messages) {
        int[] key = new int[messages.length + 1];
        key[0] = configuration;
        for (int port = 0; port < messages.length; port++) {
            key[port + 1] = messages[port] < 0 ? 0 : kind(configuration, port, messages[port]);
        }
        Row row = known.get(new IntKey(key));
        if (row == null) {
            between.run();
            row = compute(configuration, messages);
            known.put(new IntKey(key), row);
        }
        return row;
    }

    private Row compute(int configuration, int[] messages) {
        @Nullable Value[] read = new Value[messages.length];
        for (int port = 0; port < read.length; port++) {
            read[port] = messages[port] < 0 ? null : value(inputs.get(port).get(messages[port]));
        }
        ComponentSemantics.Prospect prospect =
                behaviour.prospect(configurations.get(configuration), Input.of(read), between);
        Set<IntKey> outcomes = new LinkedHashSet<>();
        if (!prospect.errors().isEmpty()) {
            int[] end = new int[1 + outputs.size()];
            end[0] = END;
            outcomes.add(new IntKey(end));
        }
        prospect.reactions().forEach(reaction -> outcomes.add(outcome(reaction)));
        return new Row(outcomes.stream().flatMapToInt(each -> Arrays.stream(each.all())).toArray());
    }

    private IntKey outcome(JointReaction reaction) {
        int[] outcome = new int[1 + outputs.size()];
        outcome[0] = number(reaction.next());
        for (int port = 0; port < outputs.size(); port++) {
            outcome[port + 1] = outputs.get(port).number(reaction.output().ports().get(port));
        }
        return new IntKey(outcome);
    }
}
