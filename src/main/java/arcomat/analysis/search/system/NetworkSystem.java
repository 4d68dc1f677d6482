package arcomat.analysis.search.system;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.composition.EventUnfolding;
import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.composition.GlobalStep;
import arcomat.analysis.search.composition.SliceUnfolding;
import arcomat.analysis.search.composition.Unfolding;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.letter.LetterClassesPool;
import arcomat.analysis.search.letter.Representatives;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.StepCache;
import arcomat.analysis.search.step.StepCollector;
import arcomat.analysis.search.step.Steps;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.Attention;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * A composition of parts, unfolded as far as a search asks for it. Connections that are no ports of
 * the whole are hidden.
 */
public final class NetworkSystem implements TransitionSystem {
    private final Network network;
    private final Unfolding unfolding;
    private final List<Port> inputs;
    private final int[] observed;
    private final OutputCubes outputs;

    private final Numbering<GlobalState> wholes = new Numbering<>();
    private final LetterClassesPool foci;
    private final List<LetterClasses> focus = new ArrayList<>();
    private final List<StepCache> steps = new ArrayList<>();

    /** Data that the composition itself only passes on and compares, whatever others do. */
    private DataIndependence own;

    /**
     * @param component a composite
     * @param compared names of the output ports that are compared
     */
    public NetworkSystem(
            Component component,
            List<Value> arguments,
            List<String> compared,
            OutputCubes outputs,
            Budget budget) {
        this.network = Network.of(component, arguments);
        this.unfolding =
                profile() == Component.Profile.EVENT_DRIVEN
                        ? new EventUnfolding(network, compared, budget)
                        : new SliceUnfolding(network, compared, budget);
        this.outputs = outputs;
        this.inputs = network.inputs().stream().map(NetworkSystem::named).toList();
        this.foci = new LetterClassesPool(inputs, budget);
        List<String> names = network.outputs().stream().map(Network.External::name).toList();
        this.observed = compared.stream().mapToInt(names::indexOf).toArray();
    }

    /** Why a composite cannot be unfolded; empty if it can. */
    public static Optional<String> obstacle(Component component, List<Value> arguments) {
        return component.profile() == Component.Profile.EVENT_DRIVEN
                ? EventUnfolding.obstacle(Network.of(component, arguments))
                : Optional.empty();
    }

    private static Port named(Network.External external) {
        Port port = external.port();
        return new Port(
                external.name(),
                port.direction(),
                port.type(),
                port.total(),
                port.delay(),
                port.promised(),
                port.latched(),
                port.first(),
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
        return network.outputs().stream().map(NetworkSystem::named).toList();
    }

    @Override
    public int[] delays() {
        Set<Integer> delayed = network.delayed();
        boolean slices = profile() == Component.Profile.TIME_SYNCHRONOUS;
        return IntStream.of(observed)
                .map(i -> i < 0 ? Network.UNCONNECTED : network.outputs().get(i).signal())
                .map(s -> !slices || s == Network.UNCONNECTED ? -1 : delayed.contains(s) ? 1 : 0)
                .toArray();
    }

    @Override
    public Map<String, String> twins() {
        Map<Integer, String> compared = new HashMap<>();
        for (int i : observed) {
            if (i >= 0) {
                Network.External port = network.outputs().get(i);
                compared.putIfAbsent(port.signal(), port.name());
            }
        }
        Map<String, String> twins = new HashMap<>();
        for (Network.External port : network.outputs()) {
            if (port.signal() != Network.UNCONNECTED && compared.containsKey(port.signal())) {
                twins.put(port.name(), compared.get(port.signal()));
            }
        }
        return twins;
    }

    @Override
    public Steps openings() {
        return steps(unfolding.beginnings());
    }

    @Override
    public LetterClasses focus(int configuration) {
        LetterClasses known = focus.get(configuration);
        if (known == null) {
            Attention attention = attention(configuration);
            known = foci.of(attention);
            focus.set(configuration, known);
        }
        return known;
    }

    private Attention attention(int configuration) {
        GlobalState whole = wholes.get(configuration);
        if (whole.isError()) {
            return Attention.none(inputs.size());
        }
        own = own == null ? new DataIndependence(this, this, observed.length) : own;
        Representatives standIns =
                own.any() ? own.standIns(own.held(configuration)) : Representatives.NONE;
        return unfolding.attention(whole, standIns);
    }

    @Override
    public Steps steps(int configuration, long kind, Value[] letter) {
        StepCache known = steps.get(configuration);
        Steps found = known.find(kind);
        if (found != null) {
            return found;
        }
        GlobalState before = wholes.get(configuration);
        return known.add(
                kind, steps(before.isError() ? List.of() : unfolding.reactions(before, letter)));
    }

    private Steps steps(List<GlobalStep> outcomes) {
        StepCollector collector = new StepCollector();
        for (GlobalStep outcome : outcomes) {
            boolean error = outcome.next().isError();
            collector.add(
                    error ? OutputCubes.ERROR : outputs.number(compared(outcome.sent())),
                    number(outcome.next()),
                    outcome.causes(),
                    new Output(outcome.sent()));
        }
        return collector.steps();
    }

    private Output compared(List<Sent> sent) {
        List<Sent> compared = new ArrayList<>(observed.length);
        for (int position : observed) {
            compared.add(position < 0 ? new Sent.Anything() : sent.get(position));
        }
        return new Output(compared);
    }

    @Override
    public Optional<String> leftOut() {
        return unfolding.leftOut();
    }

    private int number(GlobalState whole) {
        int number = wholes.number(whole);
        if (number == steps.size()) {
            focus.add(null);
            steps.add(new StepCache());
        }
        return number;
    }

    @Override
    public boolean postpones() {
        return unfolding.postpones();
    }

    /** Never: even where every part is in chaos, what it sends has its type. Sound without. */
    @Override
    public boolean isChaos(int configuration) {
        return false;
    }

    @Override
    public boolean mayErr() {
        return RunErrors.arePossible(network);
    }

    @Override
    public String name(int configuration) {
        GlobalState whole = wholes.get(configuration);
        return whole.parts() + " " + whole.registers();
    }

    @Override
    public String describe(int configuration) {
        GlobalState whole = wholes.get(configuration);
        if (whole.isError()) {
            return whole.problem().isEmpty() ? "error" : "error: " + whole.problem();
        }
        List<String> words = new ArrayList<>();
        for (int i = 0; i < whole.parts().size(); i++) {
            if (!whole.parts().get(i).isEmpty()) {
                words.add(
                        network.instances().get(i).path()
                                + ": "
                                + ConfigurationText.of(
                                        unfolding.behaviours().get(i), whole.parts().get(i)));
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
    public DataPlaces data(DataSorts sorts) {
        NetworkPlaces data = new NetworkPlaces(network, unfolding.behaviours(), sorts);
        List<Integer> compared =
                IntStream.of(observed)
                        .mapToObj(i -> i < 0 ? DataPlaces.NOWHERE : data.output(i))
                        .toList();
        return new PlacedData(data.inputs(), compared) {
            @Override
            public void held(int configuration, Holding holding) {
                GlobalState whole = wholes.get(configuration);
                for (int part = 0; part < whole.parts().size() && !whole.isError(); part++) {
                    held(whole.parts().get(part), data.variables(part), holding);
                }
                for (int register = 0; register < whole.registers().size(); register++) {
                    int place = data.signal(unfolding.signal(register));
                    if (place != NOWHERE) {
                        held(whole.registers().get(register), place, holding);
                    }
                }
            }
        };
    }

    @Override
    public int size() {
        return wholes.size();
    }
}
