package arcomat.analysis.search.composition;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointError;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The parts of an event-driven network: how one of them takes an event, and where its messages go.
 * A message that is left open, and that a part will read, is divided into all its values.
 */
final class EventReactions {
    private final Budget budget;
    private final Network network;
    private final Wiring wiring;
    private final List<ComponentSemantics> behaviours;

    /** By part and port the latched external input that feeds it, else {@code INSIDE}. */
    private final int[][] held;

    private @Nullable String leftOut;

    EventReactions(Network network, Wiring wiring, Budget budget) {
        this.budget = budget;
        this.network = network;
        this.wiring = wiring;
        this.behaviours = ComponentSemantics.ofParts(network, budget::insist);
        this.held = new int[network.instances().size()][];
        int[] latchedInputs = latchedInputs(network);
        for (int part = 0; part < held.length; part++) {
            Network.Instance instance = network.instances().get(part);
            held[part] =
                    instance.inputSignals().stream()
                            .mapToInt(s -> s < 0 ? RunToCompletion.INSIDE : latchedInputs[s])
                            .toArray();
        }
    }

    private static int[] latchedInputs(Network network) {
        int[] positions = new int[network.signals()];
        Arrays.fill(positions, RunToCompletion.INSIDE);
        for (int i = 0; i < network.inputs().size(); i++) {
            if (network.inputs().get(i).port().latched()) {
                positions[network.inputs().get(i).signal()] = i;
            }
        }
        return positions;
    }

    List<ComponentSemantics> behaviours() {
        return behaviours;
    }

    /** The latched external input that a port of a part reads, else {@code INSIDE}. */
    int held(int part, int port) {
        return held[part][port];
    }

    Optional<String> leftOut() {
        return Optional.ofNullable(leftOut);
    }

    /** Notes that not all runs are followed; the first reason is kept. */
    void leaveOut(String reason) {
        leftOut = leftOut == null ? reason : leftOut;
    }

    /** How runs go on: in longer ones, or not at all. */
    record Branches(List<RunToCompletion> next, List<Unfolding.Step> errors) {}

    /** All ways in which a part begins. */
    void start(RunToCompletion run, int part, Branches found) {
        for (JointStart start : behaviours.get(part).starts(budget::insist)) {
            RunToCompletion longer = run.longer();
            longer.set(part, start.configurations());
            finish(longer, part, start.output().ports(), found);
        }
    }

    /** All ways in which a part is completed where there is nothing that it could handle. */
    void idle(RunToCompletion run, int part, Branches found) {
        Value[] nothing = new Value[behaviours.get(part).component().inputs().size()];
        for (JointReaction reaction : reactions(run, part, nothing, found)) {
            follow(run.longer(), part, reaction, found);
        }
    }

    /**
     * All ways in which the part whose turn it is takes its next event.
     *
     * @param looks by external input, widened by what the part looks at; null if nobody asks
     */
    void react(RunToCompletion run, PortAbstraction @Nullable [] looks, Branches found) {
        int part = run.nextPart();
        RunToCompletion.Event event = run.first(part);
        if (looks != null) {
            look(run.part(part), part, event, looks);
        }
        List<JointReaction> reactions = reactions(run, part, run.messages(part, event), found);
        for (JointReaction reaction : reactions) {
            RunToCompletion longer = run.longer();
            longer.take(part);
            if (reactions.size() > 1) {
                longer.setAlternative();
            }
            follow(longer, part, reaction, found);
        }
    }

    private List<JointReaction> reactions(
            RunToCompletion run, int part, Value[] messages, Branches found) {
        Prospect prospect =
                behaviours.get(part).prospect(run.part(part), Input.of(messages), budget::insist);
        prospect.errors().forEach(error -> found.errors.add(error(run, part, error)));
        return prospect.reactions();
    }

    private void follow(RunToCompletion run, int part, JointReaction reaction, Branches found) {
        reaction.reactions().forEach(each -> run.note(each.cause()));
        run.set(part, reaction.next());
        finish(run, part, reaction.output().ports(), found);
    }

    private void finish(RunToCompletion run, int part, List<Sent> output, Branches found) {
        List<List<Sent>> settled = settled(part, output);
        for (List<Sent> sent : settled) {
            send(settled.size() == 1 ? run : run.twin(), part, sent, found);
        }
    }

    private Unfolding.Step error(RunToCompletion run, int part, JointError error) {
        List<Trace.Cause> causes = run.causes();
        causes.addAll(error.causes());
        return Unfolding.Step.error(path(part) + ": " + error.message(), causes);
    }

    private String path(int part) {
        return network.instances().get(part).path();
    }

    /** Only messages from outside are looked at: those from inside are known. */
    private void look(
            List<Configuration> configurations,
            int part,
            RunToCompletion.Event event,
            PortAbstraction[] looks) {
        List<StepRelation> relations = behaviours.get(part).relations();
        for (int i = 0; i < configurations.size(); i++) {
            InputAbstraction abstraction = relations.get(i).abstraction(configurations.get(i));
            for (int port = 0; port < held[part].length; port++) {
                int origin = port == event.port() ? event.origin() : held[part][port];
                if (origin != RunToCompletion.INSIDE) {
                    looks[origin] = looks[origin].and(abstraction.looks().get(port));
                }
            }
        }
    }

    private void send(RunToCompletion run, int part, List<Sent> sent, Branches found) {
        List<Integer> signals = network.instances().get(part).outputSignals();
        for (int i = 0; i < sent.size(); i++) {
            if (sent.get(i) instanceof Sent.Messages messages) {
                Optional<String> problem =
                        deliver(run, signals.get(i), messages.values(), RunToCompletion.INSIDE);
                if (problem.isPresent()) {
                    found.errors.add(Unfolding.Step.error(problem.get(), run.causes()));
                    return;
                }
            } else {
                run.note(signals.get(i), sent.get(i));
            }
        }
        found.next.add(run);
    }

    /**
     * Puts messages on a signal: each into the latches and queues of all its readers.
     *
     * @return what goes wrong
     */
    Optional<String> deliver(RunToCompletion run, int signal, List<Value> messages, int origin) {
        for (Value message : messages) {
            run.note(signal, new Sent.Messages(List.of(message)));
            for (Wiring.Reader reader : wiring.readers.get(signal)) {
                if (wiring.port(reader).latched()) {
                    run.latch(reader.part(), reader.port(), message);
                } else if (run.waiting(reader.part()) >= capacity(reader)) {
                    return Optional.of(
                            "%s has no room for another event on '%s' (capacity %d)"
                                    .formatted(
                                            path(reader.part()),
                                            wiring.port(reader).name(),
                                            capacity(reader)));
                } else {
                    run.enqueue(
                            reader.part(),
                            new RunToCompletion.Event(reader.port(), message, origin));
                }
            }
        }
        return Optional.empty();
    }

    private int capacity(Wiring.Reader reader) {
        return network.instances().get(reader.part()).component().queueCapacity();
    }

    /** All ways to settle what somebody reads of an output; the rest stays open. */
    private List<List<Sent>> settled(int part, List<Sent> output) {
        List<List<Sent>> options = new ArrayList<>();
        for (int i = 0; i < output.size(); i++) {
            options.add(options(part, i, output.get(i)));
        }
        return CubeSplit.combinations(options, budget);
    }

    private List<Sent> options(int part, int output, Sent sent) {
        int signal = network.instances().get(part).outputSignals().get(output);
        List<Wiring.Reader> readers = wiring.readers.get(signal);
        if (sent instanceof Sent.Messages || readers.isEmpty() && !wiring.shared[signal]) {
            return List.of(sent);
        }
        boolean all = sent instanceof Sent.AnyMessage;
        if (!all
                && (wiring.observed[signal]
                        || !readers.stream().allMatch(r -> wiring.port(r).latched()))) {
            leaveOut(
                    "%s leaves open what it sends on '%s', %s; %s"
                            .formatted(
                                    path(part),
                                    wiring.sender[signal].name(),
                                    readers.isEmpty()
                                            ? "and two ports show it"
                                            : "and parts read it",
                                    "decide with transitions, or with another completion"));
            return List.of(Sent.SILENCE);
        }
        return wiring.samples(signal, all, new InputAbstraction.Whole());
    }
}
