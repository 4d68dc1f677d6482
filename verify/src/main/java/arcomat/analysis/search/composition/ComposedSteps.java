package arcomat.analysis.search.composition;

import static arcomat.analysis.search.composition.SymbolicWay.OPEN;

import arcomat.analysis.search.composition.SymbolicWay.Untold;
import arcomat.analysis.smt.DataStep;
import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Delivery.Message;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

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

    private final Network network;
    private final List<ComponentSemantics> behaviours;
    private final List<Port> inputs;
    private final Wiring wiring;
    private final Set<String> outside;
    private final Map<Integer, SymbolicPart> parts = new HashMap<>();

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
        this.wiring = new Wiring(network, compared);
        this.outside = inputs.stream().map(Port::name).collect(Collectors.toSet());
    }

    /**
     * The steps that may be possible; empty where they cannot be told. The conditions of all of
     * them stand in one that does nothing. Whether no transition is possible follows from these.
     */
    public Optional<List<DataStep>> outOf(GlobalState before) {
        if (before.isError()) {
            return Optional.of(List.of());
        }
        try {
            Set<Expression> asks = new LinkedHashSet<>();
            List<SymbolicWay> ways = ways(before, asks);
            List<DataStep> steps = new ArrayList<>();
            steps.add(new DataStep(List.copyOf(asks), Formulas.FALSE, Map.of(), List.of()));
            ways.forEach(way -> steps.add(step(way)));
            return Optional.of(steps);
        } catch (Untold open) {
            return Optional.empty();
        }
    }

    private List<SymbolicWay> ways(GlobalState before, Set<Expression> asks) {
        List<SymbolicWay> ways = beginnings(before);
        for (int part = 0; part < behaviours.size(); part++) {
            List<SymbolicWay> longer = new ArrayList<>();
            for (SymbolicWay way : ways) {
                react(part, before.parts().get(part), way, asks, longer);
                if (longer.size() > MOST) {
                    throw new Untold();
                }
            }
            ways = longer;
        }
        return ways;
    }

    private void react(
            int part,
            List<Configuration> configurations,
            SymbolicWay way,
            Set<Expression> asks,
            List<SymbolicWay> next) {
        if (configurations.size() > 1) {
            throw new Untold();
        }
        if (configurations.isEmpty()) {
            next.add(SymbolicPart.sendingAnything(way, network.instances().get(part), wiring));
            return;
        }
        parts.computeIfAbsent(part, this::part).react(configurations.get(0), way, asks, next);
    }

    private SymbolicPart part(int part) {
        return new SymbolicPart(
                network.instances().get(part),
                behaviours.get(part).relations().get(0),
                wiring,
                outside);
    }

    private List<SymbolicWay> beginnings(GlobalState before) {
        Message[] visible = new Message[wiring.delayed.length];
        for (int signal = 0; signal < visible.length; signal++) {
            visible[signal] = kept(before.registers().get(signal), signal);
        }
        Message[] silence = new Message[visible.length];
        Arrays.fill(silence, Message.SILENCE);
        List<SymbolicWay> ways =
                List.of(new SymbolicWay(Formulas.TRUE, visible, silence, List.of()));
        for (int input = 0; input < inputs.size(); input++) {
            List<SymbolicWay> longer = new ArrayList<>();
            for (SymbolicWay way : ways) {
                arrive(way, input, longer);
            }
            ways = longer;
        }
        return ways;
    }

    private Message kept(Sent sent, int signal) {
        if (!(sent instanceof Sent.Messages messages)) {
            return OPEN;
        }
        Port sender = wiring.sender[signal];
        return messages.values().stream()
                .findFirst()
                .map(value -> new Expression.Constant(value, sender.type(), sender.span()))
                .map(Message::of)
                .orElse(Message.SILENCE);
    }

    /** Where the outside sees an input again, there is one way with it, and one without. */
    private void arrive(SymbolicWay way, int input, List<SymbolicWay> ways) {
        Port port = inputs.get(input);
        int signal = network.inputs().get(input).signal();
        Expression value = new Expression.PortRead(port, port.span());
        Expression present =
                port.total()
                        ? Formulas.TRUE
                        : new Expression.PortMatches(port, new Automaton.Present(), port.span());
        if (!wiring.observed[signal] || port.total()) {
            way.visible()[signal] = new Message(present, value);
            ways.add(way);
            return;
        }
        ways.add(arrived(way, present, signal, Message.of(value)));
        ways.add(arrived(way, Formulas.not(present), signal, Message.SILENCE));
    }

    private static SymbolicWay arrived(
            SymbolicWay way, Expression condition, int signal, Message message) {
        SymbolicWay after = way.after(SymbolicWay.and(way.happens(), condition), List.of());
        after.visible()[signal] = message;
        return after;
    }

    private DataStep step(SymbolicWay way) {
        Map<String, List<Expression>> sends = new HashMap<>();
        for (Network.External output : network.outputs()) {
            int signal = output.signal();
            if (signal != Network.UNCONNECTED && wiring.observed[signal]) {
                Message sent = way.sent(signal, wiring);
                if (SymbolicWay.isTold(sent)) {
                    sends.put(output.name(), List.of(sent.value()));
                }
            }
        }
        List<Expression> stores = new ArrayList<>(way.stores());
        for (int signal = 0; signal < wiring.delayed.length; signal++) {
            Message kept = way.registers()[signal];
            if (!wiring.readers.get(signal).isEmpty() && SymbolicWay.isTold(kept)) {
                stores.add(kept.value());
            }
        }
        return new DataStep(List.of(), way.happens(), sends, stores);
    }
}
