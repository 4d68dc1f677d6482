package arcomat.analysis.search.system;

import arcomat.analysis.search.step.Steps;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.semantics.expression.DataSorts;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Another system, with something that it remembers beside each configuration about the letters that
 * were read: a history variable (Abadi, Lamport, "The existence of refinement mappings", 1991).
 * What is sent and why is the other system's business.
 *
 * @param <M> what is remembered, by equality
 */
abstract class HistorySystem<M> extends NumberedSystem<HistorySystem.State<M>> {
    final TransitionSystem system;

    /**
     * @param inner a configuration of the other system
     */
    record State<M>(int inner, M memory) {}

    HistorySystem(TransitionSystem system) {
        this.system = system;
    }

    /** What is remembered, in a name; empty where that is nothing. */
    abstract String words(M memory);

    final int number(int inner, M memory) {
        return number(new State<>(inner, memory));
    }

    /** Steps of the other system, with what is remembered after them. */
    final Steps remembering(Steps own, M memory) {
        int[] next = IntStream.of(own.next()).map(inner -> number(inner, memory)).toArray();
        return own.changed(own.outputs(), next);
    }

    @Override
    public final Component.Profile profile() {
        return system.profile();
    }

    @Override
    public final List<Port> inputs() {
        return system.inputs();
    }

    @Override
    public final List<Port> outputs() {
        return system.outputs();
    }

    @Override
    public int[] delays() {
        return system.delays();
    }

    @Override
    public final Map<String, String> twins() {
        return system.twins();
    }

    @Override
    public boolean isChaos(int configuration) {
        return system.isChaos(get(configuration).inner);
    }

    @Override
    public boolean postpones() {
        return system.postpones();
    }

    @Override
    public final boolean mayErr() {
        return system.mayErr();
    }

    @Override
    public final String describe(int configuration) {
        return system.describe(get(configuration).inner);
    }

    @Override
    public final String name(int configuration) {
        State<M> state = get(configuration);
        String words = words(state.memory);
        return system.name(state.inner) + (words.isEmpty() ? "" : " holds " + words);
    }

    @Override
    public final Set<Trace.Cause> used() {
        return system.used();
    }

    @Override
    public final Optional<String> leftOut() {
        return system.leftOut();
    }

    /** Tells the values that are remembered, where these are data. */
    void tell(M memory, DataPlaces data, DataPlaces.Holding holding) {}

    @Override
    public final DataPlaces data(DataSorts sorts) {
        DataPlaces inner = system.data(sorts);
        return new DataPlaces(
                inner.inputs(),
                inner.outputs(),
                (configuration, holding) -> {
                    State<M> state = get(configuration);
                    inner.memory().tell(state.inner, holding);
                    tell(state.memory, inner, holding);
                });
    }
}
