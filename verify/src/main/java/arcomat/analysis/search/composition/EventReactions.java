package arcomat.analysis.search.composition;

import arcomat.analysis.search.Budget;
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

import java.util.List;
import java.util.Optional;

/**
 * The parts of an event-driven network: how one of them takes an event, and where its messages go.
 */
final class EventReactions {
    private final Budget budget;
    private final Network network;
    private final EventWiring wiring;
    private final OpenMessages openMessages;
    private final List<ComponentSemantics> behaviours;
    private @Nullable String leftOut;

    EventReactions(Network network, EventWiring wiring, Budget budget) {
        this.budget = budget;
        this.network = network;
        this.wiring = wiring;
        this.openMessages = new OpenMessages(network, wiring, budget, this::leaveOut);
        this.behaviours = ComponentSemantics.ofParts(network, budget::insist);
    }

    List<ComponentSemantics> behaviours() {
        return behaviours;
    }

    /** As one, what is sent on a port one after the other. */
    Sent joined(Network.External output, List<Sent> all) {
        return openMessages.joined(output, all);
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
        List<List<Sent>> settled = openMessages.settled(part, output);
        for (List<Sent> sent : settled) {
            send(settled.size() == 1 ? run : run.twin(), part, sent, found);
        }
    }

    private Unfolding.Step error(RunToCompletion run, int part, JointError error) {
        List<Trace.Cause> causes = run.causes();
        causes.addAll(error.causes());
        return Unfolding.Step.error(wiring.problem(part, error), causes);
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
            for (int port = 0; port < abstraction.looks().size(); port++) {
                int origin = port == event.port() ? event.origin() : wiring.held(part, port);
                if (origin != EventWiring.INSIDE) {
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
                        deliver(run, signals.get(i), messages.values(), EventWiring.INSIDE);
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
            for (Wiring.Reader reader : wiring.readers(signal)) {
                if (wiring.isLatched(reader)) {
                    run.latch(reader.part(), reader.port(), message);
                } else if (run.waiting(reader.part()) >= wiring.capacity(reader)) {
                    return Optional.of(wiring.noRoom(reader));
                } else {
                    run.enqueue(
                            reader.part(),
                            new RunToCompletion.Event(reader.port(), message, origin));
                }
            }
        }
        return Optional.empty();
    }
}
