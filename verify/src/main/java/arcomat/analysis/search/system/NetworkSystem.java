package arcomat.analysis.search.system;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.composition.ComposedSteps;
import arcomat.analysis.search.composition.EventUnfolding;
import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.composition.SliceUnfolding;
import arcomat.analysis.search.composition.Unfolding;
import arcomat.analysis.search.letter.LatchedPorts;
import arcomat.analysis.search.letter.Representatives;
import arcomat.analysis.search.packed.EventNetwork;
import arcomat.analysis.search.packed.NetworkTables;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.SliceNetwork;
import arcomat.analysis.search.reduction.EqualParts;
import arcomat.analysis.search.reduction.SmallerNetwork;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.smt.DataStep;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/**
 * A composition of parts, unfolded as far as a search asks for it. Connections that are no ports of
 * the whole are hidden.
 */
public final class NetworkSystem extends ModelSystem<GlobalState> implements PackableSystem {
    /**
     * A system without what a question cannot notice.
     *
     * @param network what it is made of
     */
    public record Smaller(NetworkSystem system, SmallerNetwork network) {}

    /** More parts than that are told apart too seldom for their bits to be found one by one. */
    private static final int MOST_PACKED = 500;

    private final Network network;
    private final List<String> compared;
    private final Budget budget;
    private final Unfolding unfolding;
    private final Set<Integer> delayed;

    /** Where they are asked for. */
    private @Nullable ComposedSteps expressions;

    private final Map<Integer, Optional<List<DataStep>>> dataSteps = new HashMap<>();

    /** Data that the composition itself only passes on and compares, whatever others do. */
    private @Nullable DataIndependence own;

    private NetworkSystem(
            Network network, List<String> observed, OutputCubes cubes, Budget budget) {
        super(
                network.component(),
                named(network.inputs()),
                named(network.outputs()),
                observed,
                cubes,
                budget);
        this.network = network;
        this.compared = List.copyOf(observed);
        this.budget = budget;
        this.delayed = network.delayed();
        this.unfolding =
                profile() == Component.Profile.EVENT_DRIVEN
                        ? new EventUnfolding(network, observed, budget)
                        : new SliceUnfolding(network, observed, budget);
    }

    /**
     * @param component a composite
     * @param observed names of the output ports that are compared
     */
    public static NetworkSystem of(
            Component component,
            List<Value> arguments,
            List<String> observed,
            OutputCubes cubes,
            Budget budget) {
        return new NetworkSystem(Network.of(component, arguments), observed, cubes, budget);
    }

    /** Why a composite cannot be unfolded; empty if it can. */
    public static Optional<String> obstacle(Component component, List<Value> arguments) {
        return component.profile() == Component.Profile.EVENT_DRIVEN
                ? EventUnfolding.obstacle(Network.of(component, arguments))
                : Optional.empty();
    }

    private static List<Port> named(List<Network.External> ports) {
        return ports.stream().map(external -> external.port().named(external.name())).toList();
    }

    @Override
    int delay(int output) {
        int signal = network.outputs().get(output).signal();
        return signal == Network.UNCONNECTED ? -1 : delayed.contains(signal) ? 1 : 0;
    }

    @Override
    public Map<String, String> twins() {
        Map<Integer, String> compared = new HashMap<>();
        observed()
                .filter(i -> i >= 0)
                .mapToObj(network.outputs()::get)
                .forEach(port -> compared.putIfAbsent(port.signal(), port.name()));
        Map<String, String> twins = new HashMap<>();
        for (Network.External port : network.outputs()) {
            if (port.signal() != Network.UNCONNECTED && compared.containsKey(port.signal())) {
                twins.put(port.name(), compared.get(port.signal()));
            }
        }
        return twins;
    }

    @Override
    public boolean canBePacked() {
        return true;
    }

    /**
     * Whether it may be asked without some of its parts, or as bits: events are worked off in the
     * order of all parts, so what is true of slices is not of these.
     */
    public boolean worksInSlices() {
        return profile() == Component.Profile.TIME_SYNCHRONOUS;
    }

    /** The same system without what cannot be noticed on compared outputs; where it has slices. */
    public Smaller smaller() {
        SmallerNetwork smaller = SmallerNetwork.of(network, comparedSignals(), budget);
        return new Smaller(new NetworkSystem(smaller.network(), compared, cubes, budget), smaller);
    }

    @Override
    public PackedNetwork packed() {
        return packed(new LatchedPorts(List.of()));
    }

    /**
     * As {@link #packed()}.
     *
     * @param driven latched inputs that never lose what they hold
     */
    PackedNetwork packed(LatchedPorts driven) {
        if (unfolding.behaviours().size() > MOST_PACKED) {
            throw new PackedNetwork.CannotPack("too many parts");
        }
        return worksInSlices() ? sliced(equalParts()) : events(driven);
    }

    private SliceNetwork sliced(List<EqualParts> equal) {
        return new SliceNetwork(
                network,
                unfolding.behaviours(),
                comparedSignals(),
                equal,
                budget::insist,
                budget::takes);
    }

    private EventNetwork events(LatchedPorts driven) {
        if (own().any()) {
            throw new PackedNetwork.CannotPack("data are only passed on");
        }
        return new EventNetwork(network, unfolding.behaviours(), compared, driven, budget);
    }

    /**
     * All that its parts may do, in numbers.
     *
     * @param messages by input what may come
     * @param starts where runs begin, by configuration
     * @param most as {@link NetworkTables#of} has it
     * @param rules as there
     */
    public NetworkTables tables(
            List<List<@Nullable Value>> messages, int[] starts, int most, int rules) {
        List<GlobalState> states = IntStream.of(starts).mapToObj(this::state).toList();
        return NetworkTables.of(sliced(List.of()), messages, states, most, rules);
    }

    /** Words for its parts and signals. */
    public NetworkWords words() {
        return new NetworkWords(network, unfolding.behaviours());
    }

    /** The signals of inputs. */
    public int[] inputSignals() {
        return network.inputs().stream().mapToInt(Network.External::signal).toArray();
    }

    /**
     * The signals of compared outputs; {@link Network#UNCONNECTED} where nothing is ever sent.
     *
     * @throws PackedNetwork.CannotPack where a compared port is missing, so that all is open there
     */
    public int[] outputSignals() {
        if (observed().anyMatch(i -> i < 0)) {
            throw new PackedNetwork.CannotPack("a compared port is missing");
        }
        return observed().map(i -> network.outputs().get(i).signal()).toArray();
    }

    private List<EqualParts> equalParts() {
        List<EqualParts> equal = EqualParts.of(network, comparedSignals(), mayErr());
        return equal.isEmpty() || budget.takes(Shortcut.EQUAL_PARTS) ? equal : List.of();
    }

    /** Those of compared outputs, of those that are connected. */
    private int[] comparedSignals() {
        return observed()
                .filter(i -> i >= 0)
                .map(i -> network.outputs().get(i).signal())
                .filter(signal -> signal != Network.UNCONNECTED)
                .toArray();
    }

    @Override
    public int configuration(GlobalState state) {
        return number(state);
    }

    @Override
    public GlobalState state(int configuration) {
        return get(configuration);
    }

    @Override
    public int cube(IntFunction<Sent> shown) {
        List<Sent> sent = new ArrayList<>(Collections.nCopies(outputs().size(), Sent.SILENCE));
        observed()
                .filter(i -> i >= 0 && network.outputs().get(i).signal() != Network.UNCONNECTED)
                .forEach(i -> sent.set(i, shown.apply(network.outputs().get(i).signal())));
        return observed(sent);
    }

    @Override
    public Steps openings() {
        return steps(unfolding.beginnings());
    }

    @Override
    InputAbstraction abstraction(int configuration) {
        GlobalState state = get(configuration);
        if (state.isError()) {
            return InputAbstraction.none(inputs().size());
        }
        DataIndependence own = own();
        Representatives representatives =
                own.any() ? own.representatives(own.held(configuration)) : Representatives.NONE;
        return unfolding.abstraction(state, representatives);
    }

    private DataIndependence own() {
        own = own == null ? new DataIndependence(this, this, (int) observed().count()) : own;
        return own;
    }

    @Override
    Steps compute(GlobalState before, long kind, Value[] letter) {
        return steps(before.isError() ? List.of() : unfolding.reactions(before, letter));
    }

    @Override
    public Optional<List<DataStep>> dataSteps(int configuration) {
        if (!worksInSlices()) {
            return Optional.empty();
        }
        if (expressions == null) {
            expressions = new ComposedSteps(network, unfolding.behaviours(), inputs(), compared);
        }
        ComposedSteps composed = expressions;
        return dataSteps.computeIfAbsent(configuration, each -> composed.outOf(get(each)));
    }

    private Steps steps(List<Unfolding.Step> all) {
        Steps.Collector collector = new Steps.Collector();
        for (Unfolding.Step step : all) {
            collector.add(
                    step.next().isError() ? OutputCubes.ERROR : observed(step.sent()),
                    number(step.next()),
                    step.causes(),
                    new Output(step.sent()));
        }
        return collector.steps();
    }

    @Override
    public Optional<String> leftOut() {
        return unfolding.leftOut();
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
        GlobalState state = get(configuration);
        return state.parts() + " " + state.registers();
    }

    @Override
    public String describe(int configuration) {
        GlobalState state = get(configuration);
        if (state.isError()) {
            return state.problem().isEmpty() ? "error" : "error: " + state.problem();
        }
        List<String> words = new ArrayList<>();
        for (int i = 0; i < state.parts().size(); i++) {
            List<Configuration> part = state.parts().get(i);
            if (!part.isEmpty()) {
                String text = ConfigurationText.of(unfolding.behaviours().get(i), part);
                words.add(network.instances().get(i).path() + ": " + text);
            }
        }
        return String.join(", ", words);
    }

    @Override
    public DataPlaces data(DataSorts sorts) {
        NetworkPlaces places = new NetworkPlaces(network, unfolding.behaviours(), sorts);
        return new DataPlaces(
                places.inputs(),
                observed(places::output),
                (configuration, holding) -> tell(get(configuration), places, holding));
    }

    private void tell(GlobalState state, NetworkPlaces places, DataPlaces.Holding holding) {
        for (int part = 0; part < state.parts().size() && !state.isError(); part++) {
            holding.values(state.parts().get(part), places.variables(part));
        }
        for (int register = 0; register < state.registers().size(); register++) {
            int place = places.signal(unfolding.signal(register));
            if (place != DataPlaces.NOWHERE) {
                holding.values(state.registers().get(register), place);
            }
        }
    }
}
