package arcomat.simulate.run;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.WhyNot;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Actor.Impasse;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Runs any well-formed model, an underspecified one as well: what is left open, a {@link Choice}
 * decides.
 *
 * <p>Time-synchronous: a step is a slice. Its activities tell how the automata react to the input
 * of this slice; the messages of a reaction are visible in the same slice on ports with delay 0,
 * and in the next slice on ports with delay 1, which show their initial output in slice 0.
 *
 * <p>Event-driven: a step is one event and all that follows from it until every queue is empty. The
 * first step begins with the initial outputs and what they cause. A letter without a message is a
 * step without an event; a latched port takes its message without one.
 */
public final class Interpreter implements Execution {
    /** The step that the run is in, or about to enter. */
    private int number;

    private final Network network;
    private final Choice choice;
    private final boolean explaining;
    private @Nullable Engine engine;
    private Optional<Trace.End> end = Optional.empty();
    private final List<String> decisions;

    /** Time-synchronous or event-driven. */
    interface Engine {
        Trace.Step step(Letter input, int number);

        /** Slices have no beginning of their own. */
        default Optional<Letter> opening() {
            return Optional.empty();
        }

        /** What is to be seen of a step that goes wrong. */
        Trace.End end(Letter input);
    }

    /**
     * @param arguments one per parameter of the component
     */
    public Interpreter(Component component, List<Value> arguments, Choice choice) {
        network = Network.of(component, arguments);
        decisions = new ArrayList<>();
        this.choice = new RememberedChoice(choice, decisions);
        explaining = false;
    }

    private Interpreter(
            Network network, Choice choice, List<String> decisions, boolean explaining) {
        this.network = network;
        this.choice = choice;
        this.decisions = decisions;
        this.explaining = explaining;
    }

    /** One for runs without an end: it does not remember its choices. */
    public static Interpreter forgetful(Component component, List<Value> arguments, Choice choice) {
        Network network = Network.of(component, arguments);
        return new Interpreter(network, choice, new ArrayList<>(), false);
    }

    /**
     * The same run, told with why no transition was enabled where none was ({@link
     * Trace.Activity#nearest}), and in a message that says so; and with what parts send ({@link
     * Trace.Step#between}). To be called before the first step.
     */
    public Interpreter explaining() {
        return new Interpreter(network, choice, decisions, true);
    }

    /** Made in the first step, which so reports what goes wrong in the beginning. */
    private Engine engine() {
        if (engine == null) {
            List<Actor> actors = actors();
            List<Network.External> heard = explaining ? sent(network) : List.of();
            engine =
                    isTimed()
                            ? new Slices(network, actors, heard)
                            : new Events(network, actors, heard);
        }
        return engine;
    }

    /** The ports by which parts send, under their paths. */
    private static List<Network.External> sent(Network network) {
        List<Network.External> ports = new ArrayList<>();
        for (Network.Instance each : network.instances()) {
            List<Port> outputs = each.component().outputs();
            for (int i = 0; i < outputs.size() && !each.path().isEmpty(); i++) {
                Port port = outputs.get(i);
                String name = each.path() + "." + port.name();
                ports.add(new Network.External(name, port, each.outputSignals().get(i)));
            }
        }
        return ports;
    }

    private List<Actor> actors() {
        Map<Component, Map<List<Value>, Acting>> behaviours = new IdentityHashMap<>();
        List<Actor> actors = new ArrayList<>(network.instances().size());
        for (Network.Instance instance : network.instances()) {
            Acting acting =
                    behaviours
                            .computeIfAbsent(instance.component(), c -> new HashMap<>())
                            .computeIfAbsent(instance.arguments(), a -> acting(instance));
            actors.add(new Actor(instance, acting.behaviour, choice, acting.whyNot));
        }
        return actors;
    }

    /** What instances of one component with the same arguments share. */
    private record Acting(ComponentSemantics behaviour, Optional<List<WhyNot>> whyNot) {}

    private Acting acting(Network.Instance instance) {
        ComponentSemantics behaviour =
                ComponentSemantics.of(instance.component(), instance.arguments());
        return new Acting(
                behaviour,
                explaining
                        ? Optional.of(behaviour.relations().stream().map(WhyNot::of).toList())
                        : Optional.empty());
    }

    @Override
    public Component component() {
        return network.component();
    }

    /** The network that runs, with its external ports. */
    public Network network() {
        return network;
    }

    /** The real choices so far, one line each, such as {@code slice 3: driving -> waiting}. */
    public List<String> decisions() {
        return List.copyOf(decisions);
    }

    @Override
    public Trace.Step step(Letter input) {
        int now = number++;
        try {
            return engine().step(input, now);
        } catch (ModelError problem) {
            boolean allowed = !(problem instanceof Impasse);
            end = allowed ? Optional.of(end(input)) : Optional.empty();
            String unit = isTimed() ? "slice " : "step ";
            throw new ModelError(unit + now + ": " + problem.getMessage());
        }
    }

    /** A run that cannot even begin shows nothing. */
    private Trace.End end(Letter input) {
        return engine == null ? new Trace.End(input, Letter.SILENCE) : engine.end(input);
    }

    @Override
    public Optional<Letter> opening() {
        return engine == null ? Optional.empty() : engine.opening();
    }

    @Override
    public Optional<Trace.End> end() {
        return end;
    }

    private boolean isTimed() {
        return component().profile() == Component.Profile.TIME_SYNCHRONOUS;
    }
}
