package arcomat.symbols.signatures;

import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.TypeSubstitution;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

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

    private static Ancestor above(Ancestor ancestor) {
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
        if (nearestFirst.size() == 1) {
            return heir.ownPorts();
        }
        List<PortSymbol> all = new ArrayList<>();
        for (int i = nearestFirst.size() - 1; i > 0; i--) {
            Ancestor ancestor = nearestFirst.get(i);
            for (PortSymbol port : ancestor.component().ownPorts()) {
                all.add(port.inherited(ancestor.substitution(), heir.defaultDelay()));
            }
        }
        all.addAll(heir.ownPorts());
        return List.copyOf(all);
    }

    private List<ParameterSymbol> collectParameters() {
        if (nearestFirst.size() == 1) {
            return heir.ownParameters();
        }
        Map<String, ParameterSymbol> inherited = new LinkedHashMap<>();
        for (int i = nearestFirst.size() - 1; i > 0; i--) {
            nearestFirst
                    .get(i)
                    .component()
                    .ownParameters()
                    .forEach(p -> inherited.put(p.name(), p));
        }
        heir.ownParameters().forEach(p -> inherited.remove(p.name()));
        List<ParameterSymbol> all = new ArrayList<>(inherited.values());
        all.addAll(heir.ownParameters());
        return List.copyOf(all);
    }

    private List<VariableSymbol> collectVariables() {
        if (nearestFirst.size() == 1) {
            return heir.ownVariables();
        }
        List<VariableSymbol> all = new ArrayList<>();
        for (int i = nearestFirst.size() - 1; i >= 0; i--) {
            all.addAll(nearestFirst.get(i).component().ownVariables());
        }
        return List.copyOf(all);
    }
}
