package arcomat.pipeline.analysis;

import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.expression.Arguments;
import arcomat.semantics.expression.Scope;
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
            List<Value> arguments = Arguments.complete(whole, List.of());
            for (Network.Instance instance : Network.of(whole, arguments).instances()) {
                add(instance.component(), instance.arguments());
            }
            collectDecomposed(whole, arguments);
        } catch (ModelError argumentsGoWrong) {
            // Said when the whole is run; its parts are examined without it.
        }
    }

    /** Parts that have parts themselves, which a network knows nothing of. */
    private void collectDecomposed(Component whole, List<Value> arguments) {
        Scope scope = new Scope(whole, arguments);
        for (Component.Part part : parts(whole)) {
            Component component = part.component();
            if (component.isComposite()) {
                List<Value> values = part.arguments().stream().map(scope::constant).toList();
                if (add(component, values)) {
                    collectDecomposed(component, values);
                }
            }
        }
    }

    private static List<Component.Part> parts(Component whole) {
        return whole.body() instanceof Component.Composite body ? body.parts() : List.of();
    }

    /** Whether nothing has been known of these arguments. */
    private boolean add(Component component, List<Value> arguments) {
        return instances
                .computeIfAbsent(component.qualifiedName(), name -> new LinkedHashSet<>())
                .add(arguments);
    }
}
