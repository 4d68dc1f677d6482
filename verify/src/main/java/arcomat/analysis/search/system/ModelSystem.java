package arcomat.analysis.search.system;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.InputAbstraction;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/**
 * A system that is made from a model: what it sends on ports that are not compared is projected
 * away.
 *
 * @param <C> a configuration, by equality
 */
abstract class ModelSystem<C> extends NumberedSystem<C> {
    final OutputCubes cubes;
    private final Component component;
    private final List<Port> inputs;
    private final List<Port> outputs;

    /** By compared port its position among the outputs; -1 where it is none of them. */
    private final int[] observed;

    private final LetterClasses.OfConfigurations classes;

    /**
     * @param observed names of the output ports that are compared
     */
    ModelSystem(
            Component component,
            List<Port> inputs,
            List<Port> outputs,
            List<String> observed,
            OutputCubes cubes,
            Budget budget) {
        this.component = component;
        this.inputs = inputs;
        this.outputs = outputs;
        this.cubes = cubes;
        this.classes = new LetterClasses.OfConfigurations(inputs, budget);
        List<String> names = outputs.stream().map(Port::name).toList();
        this.observed = observed.stream().mapToInt(names::indexOf).toArray();
    }

    /** What a configuration pays attention to. */
    abstract InputAbstraction abstraction(int configuration);

    /** As {@link #delays}, of the output at a position, of a system that works in slices. */
    abstract int delay(int output);

    @Override
    public final Component.Profile profile() {
        return component.profile();
    }

    @Override
    public final List<Port> inputs() {
        return inputs;
    }

    @Override
    public final List<Port> outputs() {
        return outputs;
    }

    @Override
    public final int[] delays() {
        boolean slices = profile() == Component.Profile.TIME_SYNCHRONOUS;
        return observed().map(i -> i < 0 || !slices ? -1 : delay(i)).toArray();
    }

    @Override
    public final LetterClasses letterClasses(int configuration) {
        return classes.of(configuration, this::abstraction);
    }

    final IntStream observed() {
        return IntStream.of(observed);
    }

    /** The number of what is sent on compared ports. */
    final int observed(List<Sent> sent) {
        List<Sent> projected = new ArrayList<>(observed.length);
        for (int port : observed) {
            projected.add(port < 0 ? new Sent.Anything() : sent.get(port));
        }
        return cubes.number(new Output(projected));
    }

    /** The places of the compared ports, from those of all outputs. */
    final List<Integer> observed(IntFunction<Integer> place) {
        return observed().mapToObj(i -> i < 0 ? DataPlaces.NOWHERE : place.apply(i)).toList();
    }
}
