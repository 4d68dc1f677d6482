package arcomat.analysis;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What an event-driven side does with an event, written for reading: queues are lists, every run is
 * followed to its end, and an event that it has no port for is left to completions. Nothing of the
 * engine is used, only the steps of single automata.
 */
public final class NaiveEvents {
    /** Something that may be any number of messages is read inside: not for enumeration. */
    public static final class Unclear extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    private record Event(int port, Value message) {}

    /**
     * In the middle of a run to completion; between two events the queues are empty.
     *
     * @param latched by part and port, null where nothing is
     * @param sent by signal, in order; an open one stands alone
     */
    private record Run(
            List<List<Configuration>> parts,
            List<List<Value>> latched,
            List<List<Event>> queues,
            int turn,
            List<List<Sent>> sent,
            boolean error) {}

    /**
     * @param output what is sent on each output port; null for an error
     * @param next where it is then
     */
    record Step(Map<String, Sent> output, Object next) {}

    private static final Object END = "error";

    private final Network network;
    private final List<ComponentSemantics> behaviours = new ArrayList<>();

    /** A side with automata is a network of one. */
    NaiveEvents(Promise promise) {
        network = Network.of(promise.component(), promise.arguments());
        for (Network.Instance part : network.instances()) {
            behaviours.add(ComponentSemantics.of(part.component(), part.arguments()));
        }
    }

    Component component() {
        return network.component();
    }

    List<Step> starts() {
        int parts = behaviours.size();
        List<List<Value>> nothing = new ArrayList<>();
        for (Network.Instance part : network.instances()) {
            nothing.add(Collections.nCopies(part.inputSignals().size(), null));
        }
        List<Run> runs = List.of(fresh(List.of(), nothing));
        for (int part = 0; part < parts; part++) {
            List<Run> longer = new ArrayList<>();
            for (Run run : runs) {
                for (JointStart start : behaviours.get(part).starts()) {
                    List<List<Configuration>> begun = new ArrayList<>(run.parts);
                    begun.add(start.configurations());
                    Run next =
                            new Run(begun, run.latched, run.queues, run.turn, run.sent, run.error);
                    longer.addAll(sending(next, part, start.output()));
                }
            }
            runs = longer;
        }
        return finished(runs);
    }

    private Run fresh(List<List<Configuration>> parts, List<List<Value>> latched) {
        return new Run(
                parts,
                latched,
                Collections.nCopies(behaviours.size(), List.of()),
                0,
                Collections.nCopies(network.signals(), List.of()),
                false);
    }

    /**
     * @param letter one event, and what latched ports hold
     */
    List<Step> steps(Object state, Map<String, Value> letter) {
        if (state == END) {
            return List.of();
        }
        Run before = (Run) state;
        List<Run> runs = List.of(fresh(before.parts, before.latched));
        boolean seen = false;
        for (Network.External input : network.inputs()) {
            Value message = letter.get(input.name());
            if (message != null) {
                runs = delivered(runs, input.signal(), message);
                seen |= !input.port().latched();
            }
        }
        return finished(seen ? runs : idle(runs));
    }

    private List<Run> delivered(List<Run> runs, int signal, Value message) {
        return runs.stream().map(run -> delivered(run, signal, message)).toList();
    }

    private List<Run> idle(List<Run> beginnings) {
        List<Run> runs = beginnings;
        for (int part = 0; part < behaviours.size(); part++) {
            List<Run> longer = new ArrayList<>();
            for (Run run : runs) {
                longer.addAll(completed(run, part));
            }
            runs = longer;
        }
        return runs;
    }

    /** All automata of a part are completed, together. */
    private List<Run> completed(Run run, int part) {
        if (run.error) {
            return List.of(run);
        }
        List<Configuration> next = new ArrayList<>();
        Optional<Output> output = Optional.empty();
        int errors = 0;
        List<StepRelation> relations = behaviours.get(part).relations();
        for (int i = 0; i < relations.size(); i++) {
            Reaction own = relations.get(i).complete(run.parts.get(part).get(i));
            errors += own.next() == Configuration.ERROR ? 1 : 0;
            next.add(own.next());
            Output sent = own.output();
            output = i == 0 ? Optional.of(sent) : output.flatMap(known -> known.meet(sent));
        }
        if (errors > 0) {
            return errors == relations.size() ? List.of(failed(run)) : List.of();
        }
        return output.map(sent -> sending(with(run, part, next), part, sent)).orElse(List.of());
    }

    private static Run failed(Run run) {
        return new Run(run.parts, run.latched, run.queues, run.turn, run.sent, true);
    }

    private static Run with(Run run, int part, List<Configuration> next) {
        return new Run(
                replaced(run.parts, part, next),
                run.latched,
                run.queues,
                run.turn,
                run.sent,
                run.error);
    }

    private static <T> List<T> replaced(List<T> list, int position, T value) {
        List<T> copy = new ArrayList<>(list);
        copy.set(position, value);
        return copy;
    }

    /** Every way to send a letter; what is left open stays so only where nobody inside reads it. */
    private List<Run> sending(Run before, int part, Output output) {
        List<Run> runs = List.of(before);
        for (int i = 0; i < output.ports().size(); i++) {
            int signal = network.instances().get(part).outputSignals().get(i);
            Port port = network.instances().get(part).component().outputs().get(i);
            List<Run> longer = new ArrayList<>();
            for (Run run : runs) {
                longer.addAll(sending(run, signal, port, output.ports().get(i)));
            }
            runs = longer;
        }
        return runs;
    }

    private List<Run> sending(Run run, int signal, Port port, Sent sent) {
        if (run.error) {
            return List.of(run);
        }
        if (sent instanceof Sent.Messages messages) {
            Run longer = run;
            for (Value message : messages.values()) {
                longer = delivered(longer, signal, message);
            }
            return List.of(longer);
        }
        List<Run> ways = new ArrayList<>();
        if (sent instanceof Sent.Anything) {
            boolean shown = network.outputs().stream().anyMatch(o -> o.signal() == signal);
            if (shown || readers(signal) == 0) {
                if (readers(signal) > 0 || !run.sent.get(signal).isEmpty()) {
                    throw new Unclear();
                }
                List<List<Sent>> open = replaced(run.sent, signal, List.of(sent));
                return List.of(new Run(run.parts, run.latched, run.queues, run.turn, open, false));
            }
            if (reads(signal, false)) {
                throw new Unclear();
            }
            ways.add(run);
        }
        SomeValues.of(port.type()).forEach(value -> ways.add(delivered(run, signal, value)));
        return ways;
    }

    private long readers(int signal) {
        return network.instances().stream()
                .flatMap(part -> part.inputSignals().stream())
                .filter(each -> each == signal)
                .count();
    }

    private boolean reads(int signal, boolean latched) {
        return network.instances().stream()
                .anyMatch(
                        part -> {
                            List<Port> ports = part.component().inputs();
                            for (int i = 0; i < ports.size(); i++) {
                                if (part.inputSignals().get(i) == signal
                                        && ports.get(i).latched() == latched) {
                                    return true;
                                }
                            }
                            return false;
                        });
    }

    /** To the outside, to latches and to queues; an error where a queue is full. */
    private Run delivered(Run run, int signal, Value message) {
        if (run.error) {
            return run;
        }
        List<Sent> before = run.sent.get(signal);
        if (before.stream().anyMatch(each -> !(each instanceof Sent.Messages))) {
            throw new Unclear();
        }
        List<Sent> longer = new ArrayList<>(before);
        longer.add(Sent.of(message));
        List<List<Value>> latched = new ArrayList<>(run.latched);
        List<List<Event>> queues = new ArrayList<>(run.queues);
        for (int part = 0; part < behaviours.size(); part++) {
            Network.Instance instance = network.instances().get(part);
            for (int port = 0; port < instance.inputSignals().size(); port++) {
                if (instance.inputSignals().get(port) != signal) {
                    continue;
                }
                if (instance.component().inputs().get(port).latched()) {
                    latched.set(part, replaced(latched.get(part), port, message));
                } else if (queues.get(part).size() == instance.component().queueCapacity()) {
                    return failed(run);
                } else {
                    List<Event> queue = new ArrayList<>(queues.get(part));
                    queue.add(new Event(port, message));
                    queues.set(part, queue);
                }
            }
        }
        List<List<Sent>> sent = replaced(run.sent, signal, longer);
        return new Run(run.parts, latched, queues, run.turn, sent, false);
    }

    /** Works off all queues: part by part, again and again, one event each. */
    private List<Step> finished(List<Run> beginnings) {
        List<Step> steps = new ArrayList<>();
        List<Run> open = new ArrayList<>(beginnings);
        while (!open.isEmpty()) {
            Run run = open.remove(open.size() - 1);
            if (run.error) {
                steps.add(new Step(null, END));
            } else if (run.queues.stream().allMatch(List::isEmpty)) {
                steps.add(new Step(shown(run), fresh(run.parts, run.latched)));
            } else {
                open.addAll(reacted(run));
            }
        }
        return steps;
    }

    private List<Run> reacted(Run run) {
        int part = run.turn;
        while (run.queues.get(part).isEmpty()) {
            part = (part + 1) % behaviours.size();
        }
        List<Event> queue = run.queues.get(part);
        Value[] messages = run.latched.get(part).toArray(Value[]::new);
        messages[queue.get(0).port] = queue.get(0).message;
        Run taken =
                new Run(
                        run.parts,
                        run.latched,
                        replaced(run.queues, part, queue.subList(1, queue.size())),
                        (part + 1) % behaviours.size(),
                        run.sent,
                        false);
        Prospect prospect = behaviours.get(part).prospect(run.parts.get(part), Input.of(messages));
        List<Run> next = new ArrayList<>();
        prospect.errors().forEach(error -> next.add(failed(taken)));
        for (JointReaction reaction : prospect.reactions()) {
            next.addAll(sending(with(taken, part, reaction.next()), part, reaction.output()));
        }
        return next;
    }

    private Map<String, Sent> shown(Run run) {
        Map<String, Sent> shown = new LinkedHashMap<>();
        for (Network.External output : network.outputs()) {
            List<Sent> sent = output.signal() < 0 ? List.<Sent>of() : run.sent.get(output.signal());
            boolean open = sent.stream().anyMatch(each -> !(each instanceof Sent.Messages));
            List<Value> values = new ArrayList<>();
            sent.stream()
                    .filter(Sent.Messages.class::isInstance)
                    .forEach(each -> values.addAll(((Sent.Messages) each).values()));
            shown.put(output.name(), open ? new Sent.Anything() : new Sent.Messages(values));
        }
        return shown;
    }
}
