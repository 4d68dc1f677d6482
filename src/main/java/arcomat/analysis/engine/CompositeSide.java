package arcomat.analysis.engine;

import arcomat.analysis.Budget;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.Attention;
import arcomat.semantics.Attention.Look;
import arcomat.semantics.Configuration;
import arcomat.semantics.Fault;
import arcomat.semantics.Network;
import arcomat.semantics.Output;
import arcomat.semantics.Sent;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A composition of parts, unfolded as far as a search asks for it. Connections that are no ports of
 * the whole are hidden. The reaction to an input is what is visible in the same slice on ports
 * without delay, and in the next one on ports with delay.
 */
public final class CompositeSide implements Side {
    private static final Output NOTHING = new Output(List.of());

    private final Network network;
    private final Wiring wiring;
    private final Parts parts;
    private final List<Port> inputs;
    private final Network.External[] observed;
    private final Outputs outputs;

    private final Map<Whole, Integer> numbers = new HashMap<>();
    private final List<Whole> wholes = new ArrayList<>();
    private final Map<Attention, Focus> foci = new HashMap<>();
    private final List<Focus> focus = new ArrayList<>();
    private final List<KnownSteps> steps = new ArrayList<>();

    /**
     * @param component a composite, time-synchronous
     * @param compared names of the output ports that are compared
     */
    public CompositeSide(
            Component component,
            List<Value> arguments,
            List<String> compared,
            Outputs outputs,
            Budget budget) {
        this.network = Network.of(component, arguments);
        this.wiring = new Wiring(network, compared);
        this.parts = new Parts(network, wiring, budget);
        this.outputs = outputs;
        this.inputs = network.inputs().stream().map(CompositeSide::named).toList();
        this.observed = new Network.External[compared.size()];
        for (Network.External output : network.outputs()) {
            if (compared.contains(output.name())) {
                observed[compared.indexOf(output.name())] = output;
            }
        }
    }

    private static Port named(Network.External external) {
        Port port = external.port();
        return new Port(
                external.name(),
                port.direction(),
                port.type(),
                port.total(),
                port.delay(),
                port.latched(),
                port.span());
    }

    @Override
    public Component.Profile profile() {
        return network.component().profile();
    }

    @Override
    public List<Port> inputs() {
        return inputs;
    }

    @Override
    public List<Port> outputs() {
        return network.outputs().stream().map(CompositeSide::named).toList();
    }

    @Override
    public Steps openings() {
        StepCollector collector = new StepCollector();
        for (Slice slice : parts.starts()) {
            add(slice, collector);
        }
        return collector.steps();
    }

    @Override
    public Focus focus(int configuration) {
        Focus known = focus.get(configuration);
        if (known == null) {
            Attention attention = attention(wholes.get(configuration));
            known = foci.computeIfAbsent(attention, each -> new Focus(foci.size(), each, inputs));
            focus.set(configuration, known);
        }
        return known;
    }

    /** A message that passes through to the outside matters as a whole. An error reads nothing. */
    private Attention attention(Whole whole) {
        Look[] looks = new Look[inputs.size()];
        for (int i = 0; i < looks.length; i++) {
            looks[i] = new Attention.Unseen();
            if (isError(whole.parts())) {
                continue;
            }
            int signal = network.inputs().get(i).signal();
            looks[i] = wiring.observed[signal] ? new Attention.Whole() : new Attention.Unseen();
            for (Wiring.Reader reader : wiring.readers.get(signal)) {
                looks[i] = looks[i].and(parts.look(whole, reader.part(), reader.port()));
            }
        }
        return new Attention(List.of(looks));
    }

    @Override
    public Steps steps(int configuration, long kind, Value[] letter) {
        KnownSteps known = steps.get(configuration);
        Steps found = known.find(kind);
        return found != null ? found : known.add(kind, compute(wholes.get(configuration), letter));
    }

    private Steps compute(Whole before, Value[] letter) {
        StepCollector collector = new StepCollector();
        if (isError(before.parts())) {
            return collector.steps();
        }
        try {
            for (Slice slice : parts.reactions(before, beginning(before, letter))) {
                add(slice, collector);
            }
        } catch (Fault fault) {
            error(List.of(), collector);
        }
        return collector.steps();
    }

    private Slice beginning(Whole before, Value[] letter) {
        Sent[] visible = wiring.silence();
        for (int signal = 0; signal < visible.length; signal++) {
            visible[signal] = before.registers().get(signal);
        }
        for (int i = 0; i < letter.length; i++) {
            visible[network.inputs().get(i).signal()] =
                    letter[i] == null ? Sent.SILENCE : new Sent.Messages(List.of(letter[i]));
        }
        return new Slice(visible, visible.length);
    }

    private void add(Slice slice, StepCollector collector) {
        if (isError(slice.after)) {
            error(slice.causes, collector);
            return;
        }
        Whole next = new Whole(slice.after, List.of(slice.registers));
        List<Sent> compared = new ArrayList<>(observed.length);
        for (Network.External port : observed) {
            compared.add(port == null ? new Sent.Anything() : reaction(slice, port));
        }
        List<Sent> all = new ArrayList<>();
        network.outputs().forEach(port -> all.add(reaction(slice, port)));
        collector.add(
                outputs.number(new Output(compared)),
                number(next),
                List.copyOf(slice.causes),
                new Output(all));
    }

    private Sent reaction(Slice slice, Network.External port) {
        if (port.signal() == Network.UNCONNECTED) {
            return Sent.SILENCE;
        }
        return wiring.delayed[port.signal()]
                ? slice.registers[port.signal()]
                : slice.visible[port.signal()];
    }

    private void error(List<Trace.Cause> causes, StepCollector collector) {
        List<Configuration> error = List.of(Configuration.ERROR);
        Whole end = new Whole(List.of(error), List.of());
        collector.add(Outputs.ERROR, number(end), List.copyOf(causes), NOTHING);
    }

    private static boolean isError(List<List<Configuration>> all) {
        return all.stream().anyMatch(each -> each.contains(Configuration.ERROR));
    }

    private int number(Whole whole) {
        Integer known = numbers.get(whole);
        if (known == null) {
            known = wholes.size();
            numbers.put(whole, known);
            wholes.add(whole);
            focus.add(null);
            steps.add(new KnownSteps());
        }
        return known;
    }

    /** Never: even where every part is in chaos, what it sends has its type. Sound without. */
    @Override
    public boolean isChaos(int configuration) {
        return false;
    }

    @Override
    public String name(int configuration) {
        Whole whole = wholes.get(configuration);
        return whole.parts() + " " + whole.registers();
    }

    @Override
    public String describe(int configuration) {
        Whole whole = wholes.get(configuration);
        if (isError(whole.parts())) {
            return "error";
        }
        List<String> words = new ArrayList<>();
        for (int i = 0; i < whole.parts().size(); i++) {
            if (!whole.parts().get(i).isEmpty()) {
                words.add(
                        network.instances().get(i).path()
                                + ": "
                                + Descriptions.of(parts.behaviours().get(i), whole.parts().get(i)));
            }
        }
        return String.join(", ", words);
    }

    @Override
    public Set<Trace.Cause> used() {
        Set<Trace.Cause> causes = new LinkedHashSet<>();
        steps.forEach(each -> each.collectUsed(causes));
        return causes;
    }

    @Override
    public int size() {
        return wholes.size();
    }
}
