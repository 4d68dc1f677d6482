package arcomat.pipeline.check;

import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.Value;
import arcomat.pipeline.WrongUse;
import arcomat.semantics.expression.Arguments;
import arcomat.semantics.expression.Specialization;
import arcomat.source.Nearest;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The component that is to run, as {@code --main} names it: {@code p.Fetcher}, or {@code
 * p.Timer(2)} with a value for each parameter that has no default.
 */
public record MainComponent(Component component, List<Value> arguments) {
    private static final int NAMED_COMPONENTS = 10;

    public MainComponent {
        arguments = List.copyOf(arguments);
    }

    /**
     * By its name, with arguments in brackets or without.
     *
     * @param written such as {@code p.Robot(3, "left")}
     * @throws WrongUse where there is no such component, or the arguments do not fit it
     */
    public static MainComponent find(String written, LoweredModels models) throws WrongUse {
        Optional<WrittenComponent> named =
                WrittenComponent.parse(written, models.checked().workspace());
        if (named.isEmpty()) {
            throw new WrongUse("'" + written + "' is not a name such as p.Robot");
        }
        Component component = component(named.get().name(), models);
        return new MainComponent(component, arguments(component, named.get().arguments()));
    }

    /**
     * As above; of a component that needs arguments, where none are written, one for each of its
     * instances.
     *
     * @param instances the arguments that parts of the models give to a component
     */
    public static List<MainComponent> find(
            String written,
            LoweredModels models,
            Function<Component, Collection<List<Value>>> instances)
            throws WrongUse {
        Optional<Component> open = withoutArguments(written, models);
        List<MainComponent> given =
                open.stream()
                        .flatMap(component -> instances.apply(component).stream())
                        .map(arguments -> new MainComponent(open.get(), arguments))
                        .toList();
        return given.isEmpty() ? List.of(find(written, models)) : given;
    }

    /** The component that is named, where it needs arguments and none are written. */
    private static Optional<Component> withoutArguments(String written, LoweredModels models)
            throws WrongUse {
        Optional<WrittenComponent> named =
                WrittenComponent.parse(written, models.checked().workspace())
                        .filter(each -> each.arguments().isEmpty());
        return named.isEmpty()
                ? Optional.empty()
                : Optional.of(component(named.get().name(), models))
                        .filter(each -> !each.hasDefaults());
    }

    /** What a name as for {@link #find} may mean before the models have a meaning. */
    public static List<ComponentSymbol> symbols(String written, Workspace models) {
        return WrittenComponent.parse(written, models)
                .map(named -> named.symbols(models))
                .orElse(List.of());
    }

    /**
     * The component as a program starts it: with nobody to give it arguments.
     *
     * @throws WrongUse where it takes some and has no parts to pass them on to
     */
    public Component closed() throws WrongUse {
        if (arguments.isEmpty()) {
            return component;
        }
        if (!component.isComposite() || component.platform()) {
            throw new WrongUse(
                    "'%s' takes arguments and has no parts to pass them on to; name a component"
                            + " that it is a part of",
                    component.qualifiedName());
        }
        return Specialization.of(component, arguments);
    }

    /** The only component that is there to be deployed, for a command that names none. */
    public static MainComponent onlyDeployed(LoweredModels models) throws WrongUse {
        List<Component> deployed = models.own().stream().filter(Component::deploy).toList();
        if (deployed.size() == 1) {
            return new MainComponent(deployed.get(0), arguments(deployed.get(0), List.of()));
        }
        throw new WrongUse(
                "which component is to run? name it with --main; there are "
                        + listing(names(models.model())));
    }

    /** By its name alone. */
    public static Component component(String name, LoweredModels models) throws WrongUse {
        Model model = models.model();
        Optional<Component> found = model.component(name);
        if (found.isPresent()) {
            return found.get();
        }
        List<ComponentSymbol> known = models.checked().workspace().components(name);
        if (known.stream().anyMatch(each -> each.declaration().isOpen())) {
            throw new WrongUse(features(known.get(0), models.checked().workspace()));
        }
        if (!known.isEmpty()) {
            throw new WrongUse(
                    "component '%s' is generic and cannot run by itself; name a component with a"
                            + " part that says its type arguments",
                    name);
        }
        int hash = name.indexOf('#');
        if (hash > 0 && model.component(name.substring(0, hash)).isPresent()) {
            throw new WrongUse(
                    "'%s' names one automaton, and here a whole component is meant; write '%s'",
                    name, name.substring(0, hash));
        }
        throw new WrongUse(missing(name, names(model)));
    }

    private static String features(ComponentSymbol component, Workspace models) {
        List<String> configurations =
                models.configurations(component).stream()
                        .map(ComponentSymbol::qualifiedName)
                        .toList();
        return configurations.isEmpty()
                ? "'%s' lies in a component with features; name a component with it as a part"
                        .formatted(component.qualifiedName())
                : "'%s' has features; choose them: there are %s"
                        .formatted(component.qualifiedName(), listing(configurations));
    }

    /**
     * Why a name as for {@link #find} means nothing, as far as that is known before the models have
     * a meaning.
     */
    public static Optional<String> obstacle(String written, Workspace models) {
        Optional<WrittenComponent> named = WrittenComponent.parse(written, models);
        if (named.isEmpty() || !symbols(written, models).isEmpty() || !models.isComplete()) {
            return Optional.empty();
        }
        List<String> names =
                models.components().stream()
                        .filter(each -> !each.signature().isGeneric())
                        .map(ComponentSymbol::qualifiedName)
                        .toList();
        return Optional.of(missing(named.get().name(), names));
    }

    private static String missing(String name, List<String> names) {
        return "there is no component '" + name + "'" + hint(name, names);
    }

    private static List<String> names(Model model) {
        return model.components().stream().map(Component::qualifiedName).toList();
    }

    private static String hint(String name, List<String> names) {
        // A simple name means the component of that name in whatever package.
        Optional<String> sameSimpleName =
                names.stream().filter(n -> n.endsWith("." + name)).findFirst();
        return sameSimpleName
                .or(() -> Nearest.to(name, names))
                .map(meant -> "; did you mean '" + meant + "'?")
                .orElseGet(() -> "; there are " + listing(names));
    }

    private static String listing(List<String> names) {
        String listed = names.stream().limit(NAMED_COMPONENTS).collect(Collectors.joining(", "));
        int more = names.size() - NAMED_COMPONENTS;
        return names.isEmpty()
                ? "no components"
                : more > 0 ? listed + " and " + more + " more" : listed;
    }

    private static List<Value> arguments(Component component, List<String> written)
            throws WrongUse {
        List<Parameter> parameters = component.parameters();
        long required = parameters.stream().filter(p -> p.initial().isEmpty()).count();
        if (written.size() < required || written.size() > parameters.size()) {
            throw new WrongUse(
                    "component '%s' takes %s; write '%s%s'",
                    component.qualifiedName(),
                    signature(parameters),
                    component.qualifiedName(),
                    example(parameters));
        }
        List<Value> values = new ArrayList<>();
        for (int i = 0; i < written.size(); i++) {
            Parameter parameter = parameters.get(i);
            String text = written.get(i);
            values.add(
                    WrittenValue.parse(text, parameter.type())
                            .orElseThrow(
                                    () ->
                                            new WrongUse(
                                                    "argument '%s' of '%s' is not a value of %s,"
                                                            + " the type of '%s'",
                                                    text,
                                                    component.qualifiedName(),
                                                    parameter.type().name(),
                                                    parameter.name())));
        }
        return Arguments.complete(component, values);
    }

    /** Parameters in words, for a message about arguments. */
    public static String signature(List<Parameter> parameters) {
        if (parameters.isEmpty()) {
            return "no arguments";
        }
        return parameters.stream()
                .map(p -> p.type().name() + " " + p.name() + (p.initial().isPresent() ? "?" : ""))
                .collect(Collectors.joining(", ", "the arguments (", ")"));
    }

    /** Arguments that would do, for such a message. */
    public static String example(List<Parameter> parameters) {
        return parameters.isEmpty()
                ? ""
                : parameters.stream()
                        .map(Parameter::name)
                        .collect(Collectors.joining(", ", "(", ")"));
    }
}
