package arcomat.pipeline.compile;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Surroundings;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** One run of compiled code, with the same traces as the interpreter's. */
public final class CompiledExecution implements Execution {
    /** Time-synchronous or event-driven code, and what it has shown of itself. */
    abstract static class Engine {
        final CompiledModel model;
        final Surroundings surroundings;
        final JavaValues messages;

        /** The whole. */
        final Object object;

        final Map<String, CodeParts.Part> parts;

        /** Of the step that is under way, or went wrong. */
        Optional<Trace.End> end = Optional.empty();

        Engine(CompiledModel model, Network network, List<Value> arguments, int seed) {
            this.model = model;
            this.surroundings = new Surroundings(network);
            this.messages = new JavaValues(model);
            this.object =
                    model.instantiate(
                            model.place(model.component()).className(),
                            messages.constructorArguments(arguments, seed));
            this.parts = model.parts(object);
        }

        abstract Trace.Step step(Letter input, int number);

        /** Slices have no beginning of their own. */
        Optional<Letter> opening() {
            return Optional.empty();
        }

        /** The part that has a port of the network, whose name begins with the part's path. */
        final CodeParts.Part part(Network.External external) {
            int dot = external.name().lastIndexOf('.');
            return Objects.requireNonNull(
                    parts.get(external.name().substring(0, Math.max(0, dot))));
        }
    }

    private final CompiledModel model;
    private final Network network;
    private final List<Value> arguments;
    private final int seed;
    private @Nullable Engine engine;
    private Optional<Trace.End> beginning = Optional.empty();
    private int number;

    /**
     * @param arguments one per parameter of the component
     * @param seed of the random choices, if the model was compiled for them
     */
    public CompiledExecution(CompiledModel model, List<Value> arguments, int seed) {
        this.model = model;
        this.network = Network.of(model.component(), arguments);
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
            if (engine == null) {
                engine =
                        isTimed()
                                ? new CompiledSlices(model, network, arguments, seed)
                                : new CompiledEvents(model, network, arguments, seed);
            }
            return engine.step(input, now);
        } catch (ModelError problem) {
            if (engine == null) {
                beginning = Optional.of(new Trace.End(input, Letter.SILENCE));
            }
            String unit = isTimed() ? "slice " : "step ";
            throw new ModelError(unit + now + ": " + problem.getMessage());
        }
    }

    @Override
    public Optional<Letter> opening() {
        return engine == null ? Optional.empty() : engine.opening();
    }

    @Override
    public Optional<Trace.End> end() {
        return engine == null ? beginning : engine.end;
    }

    private boolean isTimed() {
        return component().profile() == Component.Profile.TIME_SYNCHRONOUS;
    }
}
