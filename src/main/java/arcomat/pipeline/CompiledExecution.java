package arcomat.pipeline;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.Network;
import arcomat.simulate.Surroundings;

import java.util.List;

/** One run of compiled code, with the same traces as the interpreter's. */
public final class CompiledExecution implements Execution {
    private final CompiledModel model;
    private final Network network;
    private final Surroundings surroundings;
    private final List<Value> arguments;
    private final int seed;
    private CompiledSlices slices;
    private int number;

    /**
     * @param arguments one per parameter of the component
     * @param seed of the random choices, if the model was compiled for them
     */
    public CompiledExecution(CompiledModel model, List<Value> arguments, int seed) {
        this.model = model;
        this.network = Network.of(model.component(), arguments);
        this.surroundings = new Surroundings(network);
        this.arguments = List.copyOf(arguments);
        this.seed = seed;
    }

    @Override
    public Component component() {
        return model.component();
    }

    @Override
    public Trace.Step step(Letter input) {
        int now = number++;
        try {
            if (slices == null) {
                slices = new CompiledSlices(model, network, arguments, seed);
            }
            surroundings.requireSlice(input);
            return slices.step(input, now);
        } catch (ModelError problem) {
            throw new ModelError("slice " + now + ": " + problem.getMessage());
        }
    }
}
