package arcomat.analysis.refinement;

import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Arguments;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * What has to be shown of a model: every component keeps the promises of those that it refines, and
 * every decomposition keeps what the automata on it require.
 */
public final class Obligations {
    /**
     * A promise that a model says it keeps: by a {@code refines} clause, or by an automaton on a
     * decomposed component.
     *
     * @param place what is to be shown to be right
     */
    public record Obligation(Promise left, Promise right, Span place) {}

    private final Model model;
    private final Function<Component, Set<List<Value>>> instances;
    private final List<Obligation> found = new ArrayList<>();
    private final List<String> open = new ArrayList<>();
    private final List<String> onlyRun = new ArrayList<>();

    private Obligations(Model model, Function<Component, Set<List<Value>>> instances) {
        this.model = model;
        this.instances = instances;
    }

    /**
     * The obligations of some components.
     *
     * @param obligations in the order of the components
     * @param open names of components that have some, but take arguments that nobody gives
     * @param onlyRun names of components that are part of some, and have too many ways through
     *     statements to be looked at
     */
    public record All(List<Obligation> obligations, List<String> open, List<String> onlyRun) {
        public All {
            obligations = List.copyOf(obligations);
            open = List.copyOf(open);
            onlyRun = List.copyOf(onlyRun);
        }
    }

    /**
     * What has to be shown of some components of a model.
     *
     * @param instances the arguments that parts of the model give to a component, each list once
     */
    public static All of(
            Model model,
            List<Component> components,
            Function<Component, Set<List<Value>>> instances) {
        Obligations all = new Obligations(model, instances);
        components.forEach(all::add);
        return new All(all.found, all.open, all.onlyRun);
    }

    private void add(Component component) {
        if (component.refines().isEmpty() && component.requirements().isEmpty()) {
            return;
        }
        if (component.isOnlyRun()) {
            onlyRun.add(component.qualifiedName());
            return;
        }
        Set<List<Value>> arguments =
                defaults(component).map(Set::of).orElseGet(() -> instances.apply(component));
        if (arguments.isEmpty()) {
            open.add(component.qualifiedName());
        }
        arguments.forEach(each -> add(component, each));
    }

    private void add(Component component, List<Value> arguments) {
        Promise own = Promise.of(component, arguments);
        for (String refined : component.refines()) {
            addRefined(own, model.component(refined).orElseThrow());
        }
        Promise required = Promise.required(component, arguments);
        for (Promise each :
                component.requirements().isEmpty() ? List.<Promise>of() : required.each()) {
            found.add(new Obligation(own, each, each.automata().get(0).span()));
        }
    }

    /** Parameters that correspond, as many of the same types, get the same arguments. */
    private void addRefined(Promise own, Component other) {
        if (other.isOnlyRun()) {
            onlyRun.add(other.qualifiedName());
            return;
        }
        Optional<List<Value>> arguments =
                types(other).equals(types(own.component()))
                        ? Optional.of(own.arguments())
                        : defaults(other);
        if (arguments.isPresent()) {
            Promise right = Promise.of(other, arguments.get());
            found.add(new Obligation(own, right, own.component().span()));
        } else {
            open.add(other.qualifiedName());
        }
    }

    private static List<Type> types(Component component) {
        return component.parameters().stream().map(Parameter::type).toList();
    }

    private static Optional<List<Value>> defaults(Component component) {
        boolean given = component.parameters().stream().allMatch(p -> p.initial().isPresent());
        return given ? Optional.of(Arguments.complete(component, List.of())) : Optional.empty();
    }
}
