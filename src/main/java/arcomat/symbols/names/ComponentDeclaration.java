package arcomat.symbols.names;

import arcomat.source.Span;
import arcomat.tree.Argument;
import arcomat.tree.Component;
import arcomat.tree.Unit;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A component as its file defines it, top-level or inner: where it stands and what it is called.
 */
public final class ComponentDeclaration {
    private final UnitScope scope;
    private final Component node;
    private final Optional<ComponentDeclaration> enclosing;
    private final String qualifiedName;
    private final List<ComponentDeclaration> inner;
    private final List<TypeVariable> typeParameters;
    private final FeatureChoice configuration;
    private final Optional<Variants> variants;
    private final Map<FeatureChoice, ComponentDeclaration> configurations;

    private ComponentDeclaration(
            UnitScope scope,
            Component node,
            Optional<ComponentDeclaration> enclosing,
            FeatureChoice configuration,
            Optional<Variants> variants) {
        this.scope = scope;
        this.node = node;
        this.enclosing = enclosing;
        this.configuration = configuration;
        this.variants = variants;
        this.configurations = variants.map(each -> inConfigurations(scope, each)).orElse(Map.of());
        String kind =
                enclosing.isPresent() || configuration.choices().isEmpty()
                        ? ""
                        : configuration.text();
        this.qualifiedName =
                Names.join(
                        enclosing.map(e -> e.qualifiedName).orElse(scope.unit().packageText()),
                        node.name().text() + kind);
        this.inner =
                node.elements(Component.class).stream()
                        .map(
                                c ->
                                        new ComponentDeclaration(
                                                scope,
                                                c,
                                                Optional.of(this),
                                                configuration,
                                                Optional.empty()))
                        .toList();
        this.typeParameters = node.typeParameters().stream().map(TypeVariable::new).toList();
    }

    /** One with features has all that any of its configurations has. */
    public static ComponentDeclaration topLevel(UnitScope scope, Component node) {
        Optional<Variants> variants = Variants.of(node);
        return new ComponentDeclaration(
                scope,
                variants.map(Variants::everything).orElse(node),
                Optional.empty(),
                FeatureChoice.NONE,
                variants);
    }

    /** None where there are too many: that is an error. */
    private static Map<FeatureChoice, ComponentDeclaration> inConfigurations(
            UnitScope scope, Variants variants) {
        Map<FeatureChoice, ComponentDeclaration> all = new LinkedHashMap<>();
        List<FeatureChoice> configurations = variants.configurations();
        if (configurations.size() <= Variants.MOST) {
            for (FeatureChoice each : configurations) {
                all.put(
                        each,
                        new ComponentDeclaration(
                                scope,
                                variants.node(each),
                                Optional.empty(),
                                each,
                                Optional.empty()));
            }
        }
        return all;
    }

    /** What it is one of the configurations of; what has no features is in none. */
    public FeatureChoice configuration() {
        return configuration;
    }

    /** One for each configuration; empty for what has no features. */
    public List<ComponentDeclaration> configurations() {
        return List.copyOf(configurations.values());
    }

    /**
     * Whether it is written for several configurations and is none of them: it, or the component
     * around it, has features. It has all that any of them has, and no meaning of its own.
     */
    public boolean isOpen() {
        return variants.isPresent() || enclosing.filter(ComponentDeclaration::isOpen).isPresent();
    }

    /** Its features, if it has any to choose. */
    public Optional<Variants> variants() {
        return variants;
    }

    /** The names of its features, in the order of the text. */
    public List<String> features() {
        return variants.map(Variants::names).orElse(List.of());
    }

    /**
     * The configuration that arguments choose, or this where they do not choose an allowed one.
     *
     * @param around the configuration of the component that has the arguments
     */
    public ComponentDeclaration chosen(List<Argument> arguments, FeatureChoice around) {
        return configurations.getOrDefault(
                FeatureChoice.chosen(features(), arguments, around), this);
    }

    /** The arguments that are for parameters and not for features. */
    public List<Argument> withoutFeatures(List<Argument> arguments) {
        List<String> features = features();
        return arguments.stream()
                .filter(
                        each ->
                                each.name()
                                        .filter(name -> features.contains(name.text()))
                                        .isEmpty())
                .toList();
    }

    public Component node() {
        return node;
    }

    public Unit unit() {
        return scope.unit();
    }

    /** What names in its file reach. */
    public UnitScope unitScope() {
        return scope;
    }

    public String name() {
        return node.name().text();
    }

    public Span nameSpan() {
        return node.name().span();
    }

    /** {@code package.Outer.Inner}. */
    public String qualifiedName() {
        return qualifiedName;
    }

    public Optional<ComponentDeclaration> enclosing() {
        return enclosing;
    }

    public List<ComponentDeclaration> innerComponents() {
        return inner;
    }

    public List<TypeVariable> typeParameters() {
        return typeParameters;
    }

    @Override
    public String toString() {
        return qualifiedName;
    }
}
