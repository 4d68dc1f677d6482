package arcomat.analysis.search.system;

import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.step.StepCache;
import arcomat.analysis.search.step.Steps;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.DataSorts;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * A side that remembers, beside each configuration of another one, something about the letters that
 * were read. What is sent and why is the other side's business.
 *
 * @param <M> what is remembered, by equality
 */
abstract class HistorySystem<M> implements TransitionSystem {
    final TransitionSystem side;

    /** Where the side's ports stand in its own letters. */
    final int[] positions;

    private final Numbering<State<M>> states = new Numbering<>();
    private final List<StepCache> steps = new ArrayList<>();

    /**
     * @param inner a configuration of the other side
     */
    record State<M>(int inner, M memory) {}

    HistorySystem(TransitionSystem side) {
        this.side = side;
        this.positions = IntStream.range(0, side.inputs().size()).toArray();
    }

    /** The steps with one letter of a kind, the first that was met. */
    abstract Steps compute(State<M> before, long kind, Value[] letter);

    /** What is remembered, in a name; empty where that is nothing. */
    abstract String words(M memory);

    final State<M> state(int configuration) {
        return states.get(configuration);
    }

    final int number(int inner, M memory) {
        int number = states.number(new State<>(inner, memory));
        if (number == steps.size()) {
            steps.add(new StepCache());
        }
        return number;
    }

    /** The steps of the other side with a letter. */
    final Steps own(int inner, Value[] letter) {
        return side.steps(inner, side.focus(inner).kind(letter, positions), letter);
    }

    /** Steps of the other side, with what is remembered after them. */
    final Steps remembering(Steps own, M memory) {
        int[] next = IntStream.of(own.next()).map(inner -> number(inner, memory)).toArray();
        return changed(own, own.outputs(), next);
    }

    /** Steps of the other side that send something else and lead elsewhere. */
    static Steps changed(Steps own, int[] outputs, int[] next) {
        boolean[] used = new boolean[own.size()];
        return new Steps(outputs, next, own.causes(), own.whole(), used, List.of(own));
    }

    @Override
    public final Steps steps(int configuration, long kind, Value[] letter) {
        StepCache known = steps.get(configuration);
        Steps found = known.find(kind);
        return found != null ? found : known.add(kind, compute(state(configuration), kind, letter));
    }

    @Override
    public final Component.Profile profile() {
        return side.profile();
    }

    @Override
    public final List<Port> inputs() {
        return side.inputs();
    }

    @Override
    public final List<Port> outputs() {
        return side.outputs();
    }

    @Override
    public int[] delays() {
        return side.delays();
    }

    @Override
    public final Map<String, String> twins() {
        return side.twins();
    }

    @Override
    public boolean isChaos(int configuration) {
        return side.isChaos(state(configuration).inner);
    }

    @Override
    public boolean postpones() {
        return side.postpones();
    }

    @Override
    public final boolean mayErr() {
        return side.mayErr();
    }

    @Override
    public final String describe(int configuration) {
        return side.describe(state(configuration).inner);
    }

    @Override
    public final String name(int configuration) {
        State<M> state = state(configuration);
        String words = words(state.memory);
        return side.name(state.inner) + (words.isEmpty() ? "" : " holds " + words);
    }

    @Override
    public final Set<Trace.Cause> used() {
        return side.used();
    }

    @Override
    public final Optional<String> leftOut() {
        return side.leftOut();
    }

    /** Tells the values that are remembered, where these are data. */
    void held(M memory, DataPlaces data, DataPlaces.Holding holding) {}

    @Override
    public final DataPlaces data(DataSorts sorts) {
        DataPlaces inner = side.data(sorts);
        return new DataPlaces() {
            @Override
            public int input(String port) {
                return inner.input(port);
            }

            @Override
            public int output(int observed) {
                return inner.output(observed);
            }

            @Override
            public void held(int configuration, Holding holding) {
                inner.held(state(configuration).inner, holding);
                HistorySystem.this.held(state(configuration).memory, inner, holding);
            }
        };
    }

    @Override
    public final int size() {
        return states.size();
    }
}
