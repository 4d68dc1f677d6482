package arcomat.analysis.search.composition;

import arcomat.analysis.smt.DataStep;
import arcomat.analysis.smt.Preconditions;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.Delivery;
import arcomat.semantics.expression.Delivery.Message;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The steps of a composition that works in slices, as expressions over messages from outside: the
 * parts react one after the other, and what one has sent stands in the next one's conditions
 * instead of its ports (symbolic execution: King, "Symbolic execution and program testing", CACM
 * 1976). What is not known of a message, as in chaos, is no expression: where a part reads such a
 * one, nothing can be told.
 */
public final class ComposedSteps {
    /** More ways through a slice than that are not told. */
    private static final int MOST = 200;

    /** Nor is a message of more operators. */
    private static final int LARGEST = 500;

    private static final Message SILENCE = Message.SILENCE;

    /** A message of which nothing is known, by identity. */
    private static final Message OPEN = Message.of(Formulas.TRUE);

    private final Network network;
    private final List<ComponentSemantics> behaviours;
    private final List<Port> inputs;
    private final Map<Integer, List<Preconditions>> preconditions = new HashMap<>();
    private final boolean[] delayed;
    private final boolean[] read;
    private final boolean[] shown;

    /** That the steps are no expressions, or too many. */
    private static final class Untold extends RuntimeException {
        private static final long serialVersionUID = 1L;
    }

    /** One way through a slice, as far as its parts have reacted. */
    private record Way(
            Expression happens, Message[] visible, Message[] registers, List<Expression> stores) {
        Way after(Expression condition, List<Expression> stored) {
            List<Expression> all = new ArrayList<>(stores);
            all.addAll(stored);
            return new Way(condition, visible.clone(), registers.clone(), all);
        }
    }

    /**
     * @param inputs of the composition, by their names outside
     * @param compared names of the outputs that the outside looks at
     */
    public ComposedSteps(
            Network network,
            List<ComponentSemantics> behaviours,
            List<Port> inputs,
            List<String> compared) {
        this.network = network;
        this.behaviours = behaviours;
        this.inputs = inputs;
        Wiring wiring = new Wiring(network, compared);
        delayed = wiring.delayed;
        read = new boolean[delayed.length];
        for (int signal = 0; signal < read.length; signal++) {
            read[signal] = !wiring.readers.get(signal).isEmpty();
        }
        shown = wiring.observed;
    }

    /** The steps that may be possible; empty where they cannot be told. */
    public Optional<List<DataStep>> outOf(GlobalState before) {
        if (before.isError()) {
            return Optional.of(List.of());
        }
        try {
            return Optional.of(new Slice(before).steps());
        } catch (Untold open) {
            return Optional.empty();
        }
    }

    /** All ways through one slice. */
    private final class Slice {
        private final GlobalState before;
        private final Set<Expression> asks = new LinkedHashSet<>();
        private List<Way> ways;

        Slice(GlobalState before) {
            this.before = before;
            this.ways = beginnings();
        }

        /**
         * The conditions of all ways stand in one step that does nothing. Whether no transition is
         * possible follows from them.
         */
        List<DataStep> steps() {
            for (int part = 0; part < behaviours.size(); part++) {
                List<Way> longer = new ArrayList<>();
                for (Way way : ways) {
                    react(way, part, longer);
                    if (longer.size() > MOST) {
                        throw new Untold();
                    }
                }
                ways = longer;
            }
            List<DataStep> steps = new ArrayList<>();
            steps.add(new DataStep(List.copyOf(asks), Formulas.FALSE, Map.of(), List.of()));
            ways.forEach(way -> steps.add(step(way)));
            return steps;
        }

        private List<Way> beginnings() {
            Message[] visible = new Message[delayed.length];
            for (int signal = 0; signal < visible.length; signal++) {
                visible[signal] = kept(before.registers().get(signal), signal);
            }
            Message[] silence = new Message[delayed.length];
            Arrays.fill(silence, SILENCE);
            Way way = new Way(Formulas.TRUE, visible, silence, List.of());
            List<Way> all = List.of(way);
            for (int i = 0; i < inputs.size(); i++) {
                List<Way> longer = new ArrayList<>();
                for (Way each : all) {
                    arrive(each, i, longer);
                }
                all = longer;
            }
            return all;
        }

        /** Where the outside sees an input again, there is one way with it, and one without. */
        private void arrive(Way way, int input, List<Way> ways) {
            Port port = inputs.get(input);
            int signal = network.inputs().get(input).signal();
            Expression value = new Expression.PortRead(port, port.span());
            Expression present =
                    port.total()
                            ? Formulas.TRUE
                            : new Expression.PortMatches(
                                    port, new Automaton.Present(), port.span());
            if (!shown[signal] || port.total()) {
                way.visible()[signal] = new Message(present, value);
                ways.add(way);
                return;
            }
            Way with = way.after(and(way.happens(), present), List.of());
            with.visible()[signal] = Message.of(value);
            Way without = way.after(and(way.happens(), Formulas.not(present)), List.of());
            without.visible()[signal] = SILENCE;
            ways.addAll(List.of(with, without));
        }

        private Message kept(Sent sent, int signal) {
            if (!(sent instanceof Sent.Messages messages)) {
                return OPEN;
            }
            if (messages.values().isEmpty()) {
                return SILENCE;
            }
            Value value = messages.values().get(0);
            Port sender = sender(signal);
            return Message.of(new Expression.Constant(value, sender.type(), sender.span()));
        }

        private DataStep step(Way way) {
            Map<String, List<Expression>> sends = new HashMap<>();
            for (Network.External output : network.outputs()) {
                int signal = output.signal();
                if (signal == Network.UNCONNECTED || !shown[signal]) {
                    continue;
                }
                Message sent = (delayed[signal] ? way.registers() : way.visible())[signal];
                if (sent != OPEN && sent.isCertain()) {
                    sends.put(output.name(), List.of(sent.value()));
                }
            }
            List<Expression> stores = new ArrayList<>(way.stores());
            for (int signal = 0; signal < delayed.length; signal++) {
                Message kept = way.registers()[signal];
                if (read[signal] && kept != OPEN && kept.isCertain()) {
                    stores.add(kept.value());
                }
            }
            return new DataStep(List.of(), way.happens(), sends, stores);
        }

        private void react(Way way, int part, List<Way> next) {
            List<Configuration> configurations = before.parts().get(part);
            if (configurations.size() > 1) {
                throw new Untold();
            }
            boolean promises = !configurations.isEmpty() && configurations.get(0).isState();
            if (!promises) {
                next.add(sendingAnything(way, part));
                return;
            }
            new Reaction(way, part, configurations.get(0)).addTo(next);
        }

        private Way sendingAnything(Way way, int part) {
            Way after = way.after(way.happens(), List.of());
            for (int signal : network.instances().get(part).outputSignals()) {
                put(after, signal, OPEN);
            }
            return after;
        }

        /** One part's turn. */
        private final class Reaction {
            private final Way way;
            private final int part;
            private final Configuration configuration;
            private final StepRelation relation;
            private final Delivery delivery;
            private Expression idle;

            Reaction(Way way, int part, Configuration configuration) {
                this.way = way;
                this.part = part;
                this.configuration = configuration;
                this.relation = behaviours.get(part).relations().get(0);
                this.delivery = delivery();
                this.idle = way.happens();
            }

            private Delivery delivery() {
                Network.Instance instance = network.instances().get(part);
                InputAbstraction looks = relation.abstraction(configuration);
                Map<String, Message> messages = new HashMap<>();
                for (int i = 0; i < instance.inputSignals().size(); i++) {
                    Port port = instance.component().inputs().get(i);
                    int signal = instance.inputSignals().get(i);
                    Message message =
                            signal == Network.UNCONNECTED ? SILENCE : way.visible()[signal];
                    boolean looked = !(looks.looks().get(i) instanceof InputAbstraction.Unseen);
                    if (looked && message == OPEN
                            || port.first().isPresent()
                            || port.total() && !message.isCertain()) {
                        throw new Untold();
                    }
                    messages.put(port.name(), message == OPEN ? SILENCE : message);
                }
                return new Delivery(messages);
            }

            void addTo(List<Way> next) {
                List<DataStep> steps = DataStep.outOf(configuration, relation, preconditions(part));
                List<Automaton.Transition> transitions =
                        relation.automaton().transitions().stream()
                                .filter(each -> each.source() == configuration.state())
                                .toList();
                for (int i = 0; i < steps.size(); i++) {
                    take(transitions.get(i), steps.get(i), next);
                }
                complete(next);
            }

            private void take(Automaton.Transition transition, DataStep step, List<Way> next) {
                List<Expression> conditions = new ArrayList<>();
                for (Expression ask : step.asks()) {
                    conditions.add(and(way.happens(), delivered(ask)));
                }
                asks.addAll(conditions);
                for (Expression hinders : step.asks().subList(0, 2)) {
                    idle = and(idle, Formulas.not(delivered(hinders)));
                }
                Expression happens = and(way.happens(), delivered(step.happens()));
                if (happens.equals(Formulas.FALSE)) {
                    return;
                }
                Way after =
                        way.after(happens, step.stores().stream().map(this::delivered).toList());
                Network.Instance instance = network.instances().get(part);
                for (int i = 0; i < instance.outputSignals().size(); i++) {
                    Port port = instance.component().outputs().get(i);
                    put(after, instance.outputSignals().get(i), sent(port, transition, step));
                }
                next.add(after);
            }

            private Message sent(Port port, Automaton.Transition transition, DataStep step) {
                List<Expression> values = step.sends().getOrDefault(port.name(), List.of());
                if (!values.isEmpty()) {
                    return Message.of(delivered(values.get(0)));
                }
                boolean omitted =
                        relation.automaton().omitted() == Automaton.Omitted.SILENT && !port.total();
                return transition.sends().stream()
                        .filter(send -> send.port().name().equals(port.name()))
                        .findFirst()
                        .map(Automaton.Send::emission)
                        .map(what -> what.<Message>match(m -> OPEN, () -> SILENCE, () -> OPEN))
                        .orElse(omitted ? SILENCE : OPEN);
            }

            /** What happens where no transition is possible, and no guard goes wrong. */
            private void complete(List<Way> next) {
                Automaton.Completion completion = relation.automaton().completion();
                if (idle.equals(Formulas.FALSE) || completion == Automaton.Completion.ERROR) {
                    return;
                }
                Way after = way.after(idle, List.of());
                if (completion != Automaton.Completion.IGNORE) {
                    next.add(sendingAnything(after, part));
                    return;
                }
                Network.Instance instance = network.instances().get(part);
                Map<String, Expression> held = DataStep.shown(relation, configuration);
                for (int i = 0; i < instance.outputSignals().size(); i++) {
                    Expression value = held.get(instance.component().outputs().get(i).name());
                    put(
                            after,
                            instance.outputSignals().get(i),
                            value == null ? SILENCE : Message.of(value));
                }
                next.add(after);
            }

            private Expression delivered(Expression expression) {
                Expression in = delivery.in(expression);
                boolean known =
                        in.ports().stream()
                                .map(Port::name)
                                .allMatch(
                                        name ->
                                                inputs.stream()
                                                        .anyMatch(i -> i.name().equals(name)));
                if (!known || isLong(in)) {
                    throw new Untold();
                }
                return in;
            }
        }
    }

    /** Of the transitions of its only automaton. */
    private List<Preconditions> preconditions(int part) {
        return preconditions.computeIfAbsent(
                part,
                each ->
                        Preconditions.of(
                                Component.Profile.TIME_SYNCHRONOUS,
                                behaviours.get(each).relations().get(0).automaton()));
    }

    private Port sender(int signal) {
        for (Network.Instance instance : network.instances()) {
            int output = instance.outputSignals().indexOf(signal);
            if (output >= 0) {
                return instance.component().outputs().get(output);
            }
        }
        throw new IllegalStateException("nobody sends on signal " + signal);
    }

    /** A message of which nothing is known, and that two can see, would be the same for both. */
    private void put(Way way, int signal, Message message) {
        if (message == OPEN && shown[signal] && read[signal]) {
            throw new Untold();
        }
        (delayed[signal] ? way.registers() : way.visible())[signal] = message;
    }

    /** Where one of both is false, it is; what goes wrong in the other is asked for by itself. */
    private static Expression and(Expression one, Expression two) {
        return two.equals(Formulas.FALSE) ? two : Formulas.and(one, two);
    }

    private static boolean isLong(Expression expression) {
        int[] size = new int[1];
        return size(expression, size) > LARGEST;
    }

    private static int size(Expression expression, int[] size) {
        size[0]++;
        for (Expression operand : expression.operands()) {
            if (size[0] > LARGEST) {
                return size[0];
            }
            size(operand, size);
        }
        return size[0];
    }
}
