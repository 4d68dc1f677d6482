package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Network;
import arcomat.semantics.network.Source;

import org.jspecify.annotations.Nullable;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Drives time-synchronous compiled code slice by slice. What a delayed output shows in a slice
 * stands in its field before the step; what is sent without delay, after it.
 */
final class CompiledSlices extends CompiledExecution.Engine {
    private final @Nullable MethodHandle sense;

    /** A platform component that is the whole has none: what it would do is not in the model. */
    private final Optional<MethodHandle> step;

    private final List<PortSlot> inputs = new ArrayList<>();
    private final List<PortSlot> outputs = new ArrayList<>();
    private final Set<String> delayed;
    private final List<CompiledActor> actors = new ArrayList<>();

    CompiledSlices(CompiledModel model, Network network, List<Value> arguments, int seed) {
        super(model, network, arguments, seed);
        Component component = model.component();
        CodeLayout.Place place = model.place(component);
        step = component.platform() ? Optional.empty() : Optional.of(method("step"));
        sense = place.senses() && !component.platform() ? method("sense") : null;
        delayed = delayed(component);
        for (Network.External external : network.inputs()) {
            inputs.add(slot(external));
        }
        for (Network.External external : network.outputs()) {
            if (external.signal() != Network.UNCONNECTED) {
                outputs.add(slot(external));
            }
        }
        actors.addAll(CompiledActor.all(model, network, parts, messages));
    }

    private MethodHandle method(String name) {
        try {
            return MethodHandles.publicLookup()
                    .findVirtual(object.getClass(), name, MethodType.methodType(void.class))
                    .bindTo(object);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The outputs of the whole that show what was sent in the slice before. */
    private static Set<String> delayed(Component component) {
        Set<String> names = new HashSet<>();
        if (component.isComposite()) {
            for (Composition.Output output : Composition.of(component).outputs()) {
                if (output.source() instanceof Source.FromNode from && !from.fresh()) {
                    names.add(output.port().name());
                }
            }
        } else {
            component.outputs().stream()
                    .filter(port -> port.delay() > 0)
                    .forEach(port -> names.add(port.name()));
        }
        return names;
    }

    /** A port of the whole, or of a platform component. */
    private PortSlot slot(Network.External external) {
        CodeParts.Part part = part(external);
        return new PortSlot(
                external.name(),
                external.port(),
                part.object(),
                model.place(part.component()),
                messages);
    }

    @Override
    Trace.Step step(Letter input, int number) {
        surroundings.requireSlice(input);
        inputs.forEach(slot -> slot.write(input));
        actors.forEach(CompiledActor::begin);
        Map<String, Value> shown = new LinkedHashMap<>();
        if (sense != null) {
            call(sense);
        }
        show(true, shown);
        try {
            step.ifPresent(CompiledSlices::call);
        } catch (ModelError problem) {
            end = Optional.of(new Trace.End(input, Letter.of(inOrder(shown))));
            throw new ModelError(culprit() + problem.getMessage());
        }
        show(false, shown);
        List<Trace.Activity> activities = actors.stream().map(CompiledActor::activity).toList();
        return new Trace.Step(number, input, Letter.of(inOrder(shown)), activities);
    }

    private void show(boolean before, Map<String, Value> shown) {
        for (PortSlot slot : outputs) {
            if (delayed.contains(slot.name()) == before) {
                slot.read().ifPresent(value -> shown.put(slot.name(), value));
            }
        }
    }

    private Map<String, Value> inOrder(Map<String, Value> shown) {
        Map<String, Value> ordered = new LinkedHashMap<>();
        for (PortSlot slot : outputs) {
            if (shown.containsKey(slot.name())) {
                ordered.put(slot.name(), shown.get(slot.name()));
            }
        }
        return ordered;
    }

    /** The path of the instance whose step went wrong: the first that has not taken its own. */
    private String culprit() {
        for (CompiledActor actor : actors) {
            if (!actor.hasStepped()) {
                return actor.path().isEmpty() ? "" : actor.path() + ": ";
            }
        }
        return "";
    }

    private static void call(MethodHandle method) {
        try {
            method.invoke();
        } catch (RuntimeException | Error e) {
            throw e;
        } catch (Throwable e) {
            throw new IllegalStateException(e);
        }
    }
}
