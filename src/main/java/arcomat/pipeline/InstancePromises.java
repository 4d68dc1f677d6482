package arcomat.pipeline;

import arcomat.analysis.Promise;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Arguments;
import arcomat.semantics.Network;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What all components of a model promise that have automata. A component with parameters is taken
 * with its defaults; one without defaults with the arguments of each of its instances.
 */
final class InstancePromises {
    private final Map<String, Set<List<Value>>> instances = new LinkedHashMap<>();

    private InstancePromises(Model model) {
        model.components().stream()
                .filter(component -> component.isComposite() && hasDefaults(component))
                .forEach(this::collect);
    }

    /** Of the components in files that the user named. */
    static List<Promise> of(Model model, CheckedModels checked) {
        InstancePromises known = new InstancePromises(model);
        List<Promise> promises = new ArrayList<>();
        for (Component component : model.components()) {
            boolean named = checked.loaded().isNamedByUser(component.span().file().path());
            if (named && !component.platform()) {
                promises.addAll(known.of(component));
            }
        }
        return promises;
    }

    private List<Promise> of(Component component) {
        if (Promise.automataOf(component).isEmpty()) {
            return List.of();
        }
        List<Promise> promises = new ArrayList<>();
        for (List<Value> arguments : arguments(component)) {
            promises.add(new Promise(component, arguments, Promise.automataOf(component)));
        }
        return promises;
    }

    private Set<List<Value>> arguments(Component component) {
        return hasDefaults(component)
                ? Set.of(Arguments.complete(component, List.of()))
                : instances.getOrDefault(component.qualifiedName(), Set.of());
    }

    private static boolean hasDefaults(Component component) {
        return component.parameters().stream()
                .map(Parameter::initial)
                .allMatch(initial -> initial.isPresent());
    }

    private void collect(Component whole) {
        try {
            Network network = Network.of(whole, Arguments.complete(whole, List.of()));
            for (Network.Instance instance : network.instances()) {
                instances
                        .computeIfAbsent(
                                instance.component().qualifiedName(), name -> new LinkedHashSet<>())
                        .add(instance.arguments());
            }
        } catch (ModelError argumentsGoWrong) {
            // Said when the whole is run; its parts are examined without it.
        }
    }
}
