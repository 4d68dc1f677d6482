package arcomat.pipeline.analysis;

import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.expression.Arguments;
import arcomat.semantics.network.Network;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The arguments that components get as parts of those that need none themselves. */
public final class InstanceArguments {
    private final Map<String, Set<List<Value>>> instances = new LinkedHashMap<>();

    private InstanceArguments() {}

    /** Of all parts in a model. */
    public static InstanceArguments in(Model model) {
        InstanceArguments all = new InstanceArguments();
        model.components().stream()
                .filter(component -> component.isComposite() && component.hasDefaults())
                .forEach(all::collect);
        return all;
    }

    /** Each list of arguments once, in the order of the instances. */
    public Set<List<Value>> of(Component component) {
        return instances.getOrDefault(component.qualifiedName(), Set.of());
    }

    /** Its defaults, where it has them, else those. */
    Set<List<Value>> orDefaultsOf(Component component) {
        return component.hasDefaults()
                ? Set.of(Arguments.complete(component, List.of()))
                : of(component);
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
