package arcomat.analysis.search.composition;

import static arcomat.analysis.search.composition.SymbolicWay.OPEN;

import arcomat.analysis.reachability.Preconditions;
import arcomat.analysis.search.composition.SymbolicWay.Untold;
import arcomat.analysis.smt.DataStep;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.Delivery;
import arcomat.semantics.expression.Delivery.Message;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** What a part with one automaton does, with the messages that it receives in its conditions. */
final class SymbolicPart {
    /** A condition or a message of more operators is not told. */
    private static final int LARGEST = 500;

    private static final Message SILENCE = Message.SILENCE;

    private final Network.Instance instance;
    private final StepRelation relation;
    private final Wiring wiring;
    private final Set<String> outside;
    private final List<Preconditions> preconditions;

    /**
     * @param outside names of the inputs of the composition
     */
    SymbolicPart(
            Network.Instance instance, StepRelation relation, Wiring wiring, Set<String> outside) {
        this.instance = instance;
        this.relation = relation;
        this.wiring = wiring;
        this.outside = outside;
        this.preconditions =
                Preconditions.of(Component.Profile.TIME_SYNCHRONOUS, relation.automaton());
    }

    /** A part that says nothing may send anything. */
    static SymbolicWay sendingAnything(SymbolicWay way, Network.Instance instance, Wiring wiring) {
        SymbolicWay after = way.after(way.happens(), List.of());
        instance.outputSignals().forEach(signal -> after.put(signal, OPEN, wiring));
        return after;
    }

    /**
     * Each way goes on in as many as the part has.
     *
     * @param asks takes the conditions that decide between them
     */
    void react(
            Configuration configuration,
            SymbolicWay way,
            Set<Expression> asks,
            List<SymbolicWay> next) {
        if (configuration.isState()) {
            new Turn(configuration, way).addTo(next, asks);
        } else {
            next.add(sendingAnything(way, instance, wiring));
        }
    }

    /** One way reaches the part. */
    private final class Turn {
        private final Configuration configuration;
        private final SymbolicWay way;
        private final Delivery delivery;

        /** That no transition so far is possible, and no guard has gone wrong. */
        private Expression idle;

        Turn(Configuration configuration, SymbolicWay way) {
            this.configuration = configuration;
            this.way = way;
            this.delivery = delivery(relation.abstraction(configuration).looks());
            this.idle = way.happens();
        }

        private Delivery delivery(List<PortAbstraction> looks) {
            Map<String, Message> messages = new HashMap<>();
            for (int i = 0; i < looks.size(); i++) {
                Port port = instance.component().inputs().get(i);
                boolean looked = !(looks.get(i) instanceof InputAbstraction.Unseen);
                messages.put(port.name(), received(port, instance.inputSignals().get(i), looked));
            }
            return new Delivery(messages);
        }

        private Message received(Port port, int signal, boolean looked) {
            Message message = signal == Network.UNCONNECTED ? SILENCE : way.visible()[signal];
            if (looked && message == OPEN
                    || port.first().isPresent()
                    || port.total() && !message.isCertain()) {
                throw new Untold();
            }
            return message == OPEN ? SILENCE : message;
        }

        void addTo(List<SymbolicWay> next, Set<Expression> asks) {
            List<DataStep> steps = DataStep.outOf(configuration, relation, preconditions);
            List<Automaton.Transition> transitions =
                    relation.automaton().transitions().stream()
                            .filter(each -> each.source() == configuration.state())
                            .toList();
            for (int i = 0; i < steps.size(); i++) {
                DataStep step = steps.get(i).asked(this::delivered);
                step.asks().forEach(ask -> asks.add(SymbolicWay.and(way.happens(), ask)));
                idle = SymbolicWay.and(idle, Formulas.not(step.tried()));
                take(transitions.get(i), step, next);
            }
            complete(next);
        }

        /**
         * @param step with messages in its conditions, and not yet in the rest of it
         */
        private void take(Automaton.Transition transition, DataStep step, List<SymbolicWay> next) {
            Expression happens = SymbolicWay.and(way.happens(), step.happens());
            if (happens.equals(Formulas.FALSE)) {
                return;
            }
            SymbolicWay after =
                    way.after(happens, step.stores().stream().map(this::delivered).toList());
            for (int i = 0; i < instance.outputSignals().size(); i++) {
                Port port = instance.component().outputs().get(i);
                after.put(instance.outputSignals().get(i), sent(port, transition, step), wiring);
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

        private void complete(List<SymbolicWay> next) {
            Automaton.Completion completion = relation.automaton().completion();
            if (idle.equals(Formulas.FALSE) || completion == Automaton.Completion.ERROR) {
                return;
            }
            SymbolicWay after = way.after(idle, List.of());
            if (completion != Automaton.Completion.IGNORE) {
                next.add(sendingAnything(after, instance, wiring));
                return;
            }
            Map<String, Expression> held = DataStep.shown(relation, configuration);
            for (int i = 0; i < instance.outputSignals().size(); i++) {
                Expression value = held.get(instance.component().outputs().get(i).name());
                Message message = value == null ? SILENCE : Message.of(value);
                after.put(instance.outputSignals().get(i), message, wiring);
            }
            next.add(after);
        }

        private Expression delivered(Expression expression) {
            Expression in = delivery.in(expression);
            if (room(in, LARGEST) < 0
                    || !in.ports().stream().map(Port::name).allMatch(outside::contains)) {
                throw new Untold();
            }
            return in;
        }
    }

    /** How many more operators there may be; negative where there are too many. */
    private static int room(Expression expression, int most) {
        int room = most - 1;
        for (Expression operand : expression.operands()) {
            room = room < 0 ? room : room(operand, room);
        }
        return room;
    }
}
