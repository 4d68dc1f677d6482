package arcomat.symbols.signatures;

import arcomat.source.Span;
import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.ComponentDeclaration;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeReferences;
import arcomat.symbols.names.TypeSubstitution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.TypeVariable;
import arcomat.tree.Argument;
import arcomat.tree.Component;
import arcomat.tree.QualifiedName;
import arcomat.tree.Stereotype;
import arcomat.tree.TypeReference;
import arcomat.tree.Unit;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * What others can see of a component: what it extends and refines, its ports, parameters and
 * constants. What is inherited comes before what is declared here; "own" leaves inherited things
 * out. Where something is declared twice, look-ups by name give the first.
 */
public final class Signature {
    /** A component that this one refines. */
    public record Refinement(QualifiedName node, Resolution<Signature> resolution) {}

    private final ComponentDeclaration declaration;
    private final Function<ComponentDeclaration, Signature> signatures;
    private final Timing timing;
    private final Members members = new Members(this);
    private final Lazy<Optional<ComponentReference>> superComponent =
            new Lazy<>(() -> node().superComponent().map(s -> ComponentReference.of(this, s)));
    private final Lazy<Inheritance> inheritance = new Lazy<>(() -> Inheritance.of(this));
    private final Lazy<List<PortSymbol>> ownPorts = new Lazy<>(members::ports);
    private final Lazy<Map<String, PortSymbol>> portsByName =
            new Lazy<>(() -> firstByName(ports()));
    private final Lazy<List<ParameterSymbol>> ownParameters = new Lazy<>(members::parameters);
    private final Lazy<List<VariableSymbol>> ownVariables = new Lazy<>(members::variables);
    private final Lazy<ValueScope> parameterScope =
            new Lazy<>(() -> emptyScope().with(parameters()));
    private final Lazy<List<GivenArgument>> superArguments = new Lazy<>(this::typeSuperArguments);
    private final Lazy<ValueScope> constantScope =
            new Lazy<>(() -> parameterScope().with(variables()));

    /**
     * @param signatures those of all components, this one included
     */
    public Signature(
            ComponentDeclaration declaration,
            Function<ComponentDeclaration, Signature> signatures) {
        this.declaration = declaration;
        this.signatures = signatures;
        this.timing = Timing.of(declaration.node());
    }

    private static Map<String, PortSymbol> firstByName(List<PortSymbol> ports) {
        Map<String, PortSymbol> map = new HashMap<>();
        ports.forEach(port -> map.putIfAbsent(port.name(), port));
        return map;
    }

    // ---- what it is -----------------------------------------------------------------------

    public ComponentDeclaration declaration() {
        return declaration;
    }

    Signature of(ComponentDeclaration other) {
        return signatures.apply(other);
    }

    public Component node() {
        return declaration.node();
    }

    public Unit unit() {
        return declaration.unit();
    }

    public String name() {
        return declaration.name();
    }

    public Span nameSpan() {
        return declaration.nameSpan();
    }

    /** {@code package.Outer.Inner}. */
    public String qualifiedName() {
        return declaration.qualifiedName();
    }

    public Optional<Signature> enclosing() {
        return declaration.enclosing().map(signatures);
    }

    public List<Signature> innerComponents() {
        return declaration.innerComponents().stream().map(signatures).toList();
    }

    public List<TypeVariable> typeParameters() {
        return declaration.typeParameters();
    }

    /**
     * What is named here, in the configuration that arguments choose. Excused where they choose
     * none, unless this is for several configurations itself: then it is what has all that any of
     * them has.
     */
    Resolution<Signature> chosen(Resolution<Signature> named, List<Argument> arguments) {
        Resolution<Signature> meant =
                named.map(
                        each ->
                                of(
                                        each.declaration.chosen(
                                                arguments, declaration.configuration())));
        boolean left = meant.found().filter(each -> each.declaration.isOpen()).isPresent();
        return left && !declaration.isOpen() ? Resolution.excused() : meant;
    }

    public boolean isGeneric() {
        return !typeParameters().isEmpty();
    }

    public List<Stereotype> stereotypes() {
        return node().stereotypes();
    }

    /** Without behaviour in the model: {@code <<platform>>} or {@code abstract}. */
    public boolean isPlatform() {
        return node().isAbstract() || Stereotype.find(stereotypes(), "platform").isPresent();
    }

    /** A main component: {@code <<deploy>>} or {@code deploy}. */
    public boolean isDeploy() {
        return node().isDeploy() || Stereotype.find(stereotypes(), "deploy").isPresent();
    }

    /** Says how the ports of one component stand for those of another: {@code <<map>>}. */
    public boolean isMap() {
        return Stereotype.find(stereotypes(), "map").isPresent();
    }

    /** The layer it belongs to; logic where none, or none that is known, is written. */
    public Layer layer() {
        return Stereotype.find(stereotypes(), "layer")
                .flatMap(Stereotype::value)
                .flatMap(value -> Layer.named(value.text()))
                .orElse(Layer.LOGIC);
    }

    /** How time passes in it; inherited where it says nothing itself. */
    public Timing timing() {
        return inheritance.get().nearestFirst().stream()
                .map(ancestor -> ancestor.component().timing)
                .filter(Timing::isWritten)
                .findFirst()
                .orElse(timing);
    }

    /** Delay of its outputs where they say nothing themselves. */
    int defaultDelay() {
        return isPlatform() ? 0 : timing().delay();
    }

    // ---- inheritance and refinement -------------------------------------------------------

    /** The component it extends, as written and resolved. */
    public Optional<ComponentReference> superComponent() {
        return superComponent.get();
    }

    /** What it gives to the parameters of the component it extends; empty if it gives nothing. */
    public List<GivenArgument> superArguments() {
        return superArguments.get();
    }

    private List<GivenArgument> typeSuperArguments() {
        if (node().superArguments().isEmpty()) {
            return List.of();
        }
        Optional<ComponentReference> above = superComponent();
        TypeSubstitution types =
                above.map(ComponentReference::substitution).orElse(TypeSubstitution.NONE);
        List<Argument> written = node().superArguments().get();
        return GivenArgument.of(
                forParameters(superNamed(), written),
                above.flatMap(ComponentReference::component)
                        .map(Signature::parameters)
                        .orElse(List.of()),
                types::apply,
                ExpressionTyping.at(parameterScope()));
    }

    /**
     * The arguments that are for parameters: those for features have chosen the component.
     *
     * @param named who they are for, seen from here; empty where that is not known
     */
    public List<Argument> forParameters(
            Optional<ComponentDeclaration> named, List<Argument> written) {
        return named.map(each -> each.withoutFeatures(written))
                .orElseGet(() -> declaration.configuration().withoutChoices(written));
    }

    /** What it extends, before a configuration is chosen. */
    public Optional<ComponentDeclaration> superNamed() {
        return node().superComponent()
                .flatMap(type -> ComponentNames.superComponent(this, type.name()).found())
                .map(Signature::declaration);
    }

    /** This component and those above it, nearest first; ends before one would come again. */
    public List<Signature> lineage() {
        return inheritance.get().nearestFirst().stream()
                .map(Inheritance.Ancestor::component)
                .toList();
    }

    /** What the type parameters of its ancestors stand for in it. */
    public TypeSubstitution inheritedArguments() {
        TypeSubstitution all = TypeSubstitution.NONE;
        for (Inheritance.Ancestor ancestor : inheritance.get().nearestFirst()) {
            all = all.and(ancestor.substitution());
        }
        return all;
    }

    /** Whether it extends itself over any number of steps. */
    public boolean isItsOwnAncestor() {
        return inheritance.get().isCyclic(this);
    }

    /** The components named behind {@code refines}. */
    public List<Refinement> refines() {
        return node().refined().stream()
                .map(
                        each ->
                                new Refinement(
                                        each.name(),
                                        chosen(resolveComponent(each.name()), each.arguments())))
                .toList();
    }

    // ---- members --------------------------------------------------------------------------

    public List<PortSymbol> ownPorts() {
        return ownPorts.get();
    }

    /** All ports, inherited ones first. A port declared again appears again. */
    public List<PortSymbol> ports() {
        return inheritance.get().ports();
    }

    public Optional<PortSymbol> port(String name) {
        return Optional.ofNullable(portsByName.get().get(name));
    }

    public List<ParameterSymbol> ownParameters() {
        return ownParameters.get();
    }

    /**
     * All parameters in the order of arguments: inherited ones first, unless declared again under
     * the same name, or given an argument on the way.
     */
    public List<ParameterSymbol> parameters() {
        return inheritance.get().parameters();
    }

    /** Whether a part can be made of it by its name alone: every parameter has a default. */
    public boolean needsNoArguments() {
        return !isGeneric()
                && parameters().stream().allMatch(each -> each.node().initial().isPresent());
    }

    public List<VariableSymbol> ownVariables() {
        return ownVariables.get();
    }

    /** Variables of the component itself, inherited ones first. */
    public List<VariableSymbol> variables() {
        return inheritance.get().variables();
    }

    // ---- scopes ---------------------------------------------------------------------------

    /** What constants may read: parameters. */
    public ValueScope parameterScope() {
        return parameterScope.get();
    }

    /** What arguments of instances may read: parameters and constants. */
    public ValueScope constantScope() {
        return constantScope.get();
    }

    public ValueScope emptyScope() {
        return ValueScope.empty(declaration.unitScope(), this::resolveType);
    }

    /** A type as written inside this component: type parameters come first. */
    public Resolution<TypeSymbol> resolveType(TypeReference reference) {
        return TypeReferences.resolve(reference, name -> ComponentNames.type(this, name));
    }

    /** A component named inside this one: inner components, also of those around, come first. */
    public Resolution<Signature> resolveComponent(QualifiedName name) {
        return ComponentNames.component(this, name);
    }

    @Override
    public String toString() {
        return qualifiedName();
    }
}
