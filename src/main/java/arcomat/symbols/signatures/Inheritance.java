package arcomat.symbols.signatures;

import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.TypeSubstitution;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;

/** The ancestors of a component, and what it has from them. */
final class Inheritance {
    /** A component with what its type parameters stand for in the heir. */
    record Ancestor(Signature component, TypeSubstitution substitution) {}

    private final Signature heir;
    private final List<Ancestor> nearestFirst;
    private final Lazy<List<PortSymbol>> ports = new Lazy<>(this::collectPorts);
    private final Lazy<List<ParameterSymbol>> parameters = new Lazy<>(this::collectParameters);
    private final Lazy<List<VariableSymbol>> variables = new Lazy<>(this::collectVariables);

    private Inheritance(Signature heir, List<Ancestor> nearestFirst) {
        this.heir = heir;
        this.nearestFirst = nearestFirst;
    }

    static Inheritance of(Signature heir) {
        if (heir.node().superComponent().isEmpty()) {
            return new Inheritance(heir, List.of(new Ancestor(heir, TypeSubstitution.NONE)));
        }
        List<Ancestor> line = new ArrayList<>();
        Set<Signature> seen = new HashSet<>();
        Ancestor current = new Ancestor(heir, TypeSubstitution.NONE);
        while (current != null && seen.add(current.component())) {
            line.add(current);
            current = above(current);
        }
        return new Inheritance(heir, List.copyOf(line));
    }

    private static @Nullable Ancestor above(Ancestor ancestor) {
        Optional<ComponentReference> reference = ancestor.component().superComponent();
        return reference
                .flatMap(ComponentReference::component)
                .map(
                        component ->
                                new Ancestor(
                                        component,
                                        reference
                                                .get()
                                                .substitution()
                                                .then(ancestor.substitution())))
                .orElse(null);
    }

    List<Ancestor> nearestFirst() {
        return nearestFirst;
    }

    boolean isCyclic(Signature component) {
        Signature top = nearestFirst.get(nearestFirst.size() - 1).component();
        return top.superComponent()
                .flatMap(ComponentReference::component)
                .filter(component::equals)
                .isPresent();
    }

    List<PortSymbol> ports() {
        return ports.get();
    }

    List<ParameterSymbol> parameters() {
        return parameters.get();
    }

    List<VariableSymbol> variables() {
        return variables.get();
    }

    private List<PortSymbol> collectPorts() {
        return collect(
                ancestor ->
                        ancestor.component() == heir ? heir.ownPorts() : inheritedPorts(ancestor));
    }

    private List<PortSymbol> inheritedPorts(Ancestor ancestor) {
        return ancestor.component().ownPorts().stream()
                .map(port -> port.inherited(ancestor.substitution(), heir.defaultDelay()))
                .toList();
    }

    /**
     * What the heir declares again stands among its own. Who writes arguments for the component it
     * extends settles all parameters of that, by defaults if not by arguments.
     */
    private List<ParameterSymbol> collectParameters() {
        Map<String, ParameterSymbol> inherited = new LinkedHashMap<>();
        for (Ancestor ancestor : topFirst()) {
            if (ancestor.component().node().superArguments().isPresent()) {
                inherited.clear();
            }
            List<ParameterSymbol> own = ancestor.component().ownParameters();
            if (ancestor.component() == heir) {
                own.forEach(parameter -> inherited.remove(parameter.name()));
                return Stream.concat(inherited.values().stream(), own.stream()).toList();
            }
            own.forEach(parameter -> inherited.put(parameter.name(), parameter));
        }
        throw new AssertionError(heir);
    }

    private List<VariableSymbol> collectVariables() {
        return collect(ancestor -> ancestor.component().ownVariables());
    }

    private <T> List<T> collect(Function<Ancestor, List<T>> declared) {
        return topFirst().stream().flatMap(each -> declared.apply(each).stream()).toList();
    }

    private List<Ancestor> topFirst() {
        List<Ancestor> line = new ArrayList<>(nearestFirst);
        Collections.reverse(line);
        return line;
    }
}
