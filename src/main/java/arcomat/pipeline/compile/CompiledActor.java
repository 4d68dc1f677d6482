package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** One instance of compiled code, as a trace shows it. */
final class CompiledActor {
    /** Written before a step, so that it shows afterwards who has not taken its own. */
    private static final int NOT_YET = Integer.MIN_VALUE;

    private final String path;
    private final Automaton automaton;
    private final Slot state;
    private final Slot taken;
    private final Map<Variable, Slot> variables = new LinkedHashMap<>();
    private final JavaValues messages;
    private int before;

    CompiledActor(
            Network.Instance instance,
            Automaton automaton,
            Object object,
            CodeLayout.Place place,
            JavaValues messages) {
        this.path = instance.path();
        this.automaton = automaton;
        this.messages = messages;
        this.state = new Slot(object, place.state());
        this.taken = new Slot(object, place.taken());
        for (Variable variable : automaton.variables()) {
            variables.put(
                    variable,
                    new Slot(
                            object,
                            Objects.requireNonNull(place.variables().get(variable.name()))));
        }
    }

    /** The instances with an automaton, in the order of the network. */
    static List<CompiledActor> all(
            CompiledModel model,
            Network network,
            Map<String, CodeParts.Part> parts,
            JavaValues messages) {
        List<CompiledActor> actors = new ArrayList<>();
        for (Network.Instance instance : network.instances()) {
            if (instance.component().platform()) {
                continue;
            }
            Component.Atomic body = (Component.Atomic) instance.component().body();
            Object object = Objects.requireNonNull(parts.get(instance.path())).object();
            CodeLayout.Place where = model.place(instance.component());
            for (Automaton automaton : body.automata()) {
                actors.add(new CompiledActor(instance, automaton, object, where, messages));
            }
        }
        return actors;
    }

    String path() {
        return path;
    }

    void begin() {
        before = state.getInt();
        taken.set(NOT_YET);
    }

    boolean hasStepped() {
        return taken.getInt() != NOT_YET;
    }

    Trace.Activity activity() {
        int index = taken.getInt();
        Trace.Cause cause =
                index < 0
                        ? new Trace.Completed(automaton.completion())
                        : new Trace.Taken(index, automaton.transitions().get(index));
        Map<String, Value> values = new LinkedHashMap<>();
        variables.forEach(
                (variable, slot) ->
                        values.put(
                                variable.name(), messages.fromJava(slot.get(), variable.type())));
        return new Trace.Activity(
                path,
                automaton.name(),
                automaton.states().get(before),
                automaton.states().get(state.getInt()),
                cause,
                values,
                Optional.empty());
    }
}
