package arcomat.symbols;

import arcomat.source.Span;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.QualifiedName;
import arcomat.tree.Stereotype;
import arcomat.tree.TypeReference;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A component type, top-level or inner. What is inherited comes before what is declared here; "own"
 * leaves inherited things out. Where something is declared twice, look-ups by name give the first.
 */
public final class ComponentSymbol {

    /** A component that this one refines. */
    public record Refinement(QualifiedName node, Resolution<ComponentSymbol> resolution) {}

    private final UnitScope scope;
    private final Component node;
    private final Optional<ComponentSymbol> enclosing;
    private final String qualifiedName;
    private final List<ComponentSymbol> inner;
    private final List<TypeVariable> typeParameters;
    private final Timing timing;
    private final Lazy<Optional<ComponentReference>> superComponent;
    private final Lazy<Inheritance> inheritance = new Lazy<>(() -> Inheritance.of(this));
    private final Lazy<List<PortSymbol>> ownPorts;
    private final Lazy<Map<String, PortSymbol>> portsByName;
    private final Lazy<List<ParameterSymbol>> ownParameters;
    private final Lazy<List<VariableSymbol>> ownVariables;
    private final Lazy<List<AutomatonSymbol>> ownAutomata;
    private final Lazy<List<TableSymbol>> ownTables;
    private final Lazy<List<InstanceSymbol>> ownInstances =
            new Lazy<>(() -> Instances.declaredIn(this));
    private final Lazy<Instances> instances = new Lazy<>(() -> Instances.of(this));
    private final Lazy<Connectors> connectors = new Lazy<>(() -> Connectors.of(this));
    private final Lazy<ValueScope> parameterScope;
    private final Lazy<ValueScope> constantScope;

    ComponentSymbol(UnitScope scope, Component node, Optional<ComponentSymbol> enclosing) {
        this.scope = scope;
        this.node = node;
        this.enclosing = enclosing;
        this.qualifiedName =
                Names.join(
                        enclosing.map(e -> e.qualifiedName).orElse(scope.unit().packageText()),
                        node.name().text());
        this.inner =
                node.elements(Component.class).stream()
                        .map(c -> new ComponentSymbol(scope, c, Optional.of(this)))
                        .toList();
        this.typeParameters = node.typeParameters().stream().map(TypeVariable::new).toList();
        this.timing = Timing.of(node);
        this.superComponent =
                new Lazy<>(() -> node.superComponent().map(s -> ComponentReference.of(this, s)));
        ComponentMembers members = new ComponentMembers(this);
        this.ownPorts = new Lazy<>(members::ports);
        this.portsByName = new Lazy<>(() -> firstByName(ports()));
        this.ownParameters = new Lazy<>(members::parameters);
        this.ownVariables = new Lazy<>(members::variables);
        this.ownAutomata = new Lazy<>(members::automata);
        this.ownTables = new Lazy<>(members::tables);
        this.parameterScope = new Lazy<>(() -> emptyScope().with(parameters()));
        this.constantScope = new Lazy<>(() -> parameterScope.get().with(variables()));
    }

    private static Map<String, PortSymbol> firstByName(List<PortSymbol> ports) {
        Map<String, PortSymbol> map = new HashMap<>();
        ports.forEach(port -> map.putIfAbsent(port.name(), port));
        return map;
    }

    // ---- what it is -----------------------------------------------------------------------

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

    public Optional<ComponentSymbol> enclosing() {
        return enclosing;
    }

    public List<ComponentSymbol> innerComponents() {
        return inner;
    }

    public List<TypeVariable> typeParameters() {
        return typeParameters;
    }

    public boolean isGeneric() {
        return !typeParameters.isEmpty();
    }

    public List<Stereotype> stereotypes() {
        return node.stereotypes();
    }

    /** Without behaviour in the model: {@code <<platform>>} or {@code abstract}. */
    public boolean isPlatform() {
        return node.isAbstract() || Stereotype.find(stereotypes(), "platform").isPresent();
    }

    /** A main component: {@code <<deploy>>} or {@code deploy}. */
    public boolean isDeploy() {
        return node.isDeploy() || Stereotype.find(stereotypes(), "deploy").isPresent();
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
        for (Inheritance.Ancestor ancestor : inheritance.get().nearestFirst()) {
            if (ancestor.component().timing.isWritten()) {
                return ancestor.component().timing;
            }
        }
        return timing;
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

    /** This component and those above it, nearest first; ends before one would come again. */
    public List<ComponentSymbol> lineage() {
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
        return node.refines().stream()
                .map(name -> new Refinement(name, resolveComponent(name)))
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
     * the same name.
     */
    public List<ParameterSymbol> parameters() {
        return inheritance.get().parameters();
    }

    public List<VariableSymbol> ownVariables() {
        return ownVariables.get();
    }

    /** Variables of the component itself, inherited ones first. */
    public List<VariableSymbol> variables() {
        return inheritance.get().variables();
    }

    /** Invariants written here. */
    public List<InvariantSymbol> ownInvariants() {
        return invariantsOf(this);
    }

    /** All that hold for it, inherited ones first. */
    public List<InvariantSymbol> invariants() {
        List<InvariantSymbol> all = new ArrayList<>();
        lineage().forEach(component -> all.addAll(0, invariantsOf(component)));
        return all;
    }

    private List<InvariantSymbol> invariantsOf(ComponentSymbol component) {
        List<InvariantSymbol> all = new ArrayList<>();
        for (Element.Invariant each : component.node.elements(Element.Invariant.class)) {
            all.add(new InvariantSymbol(each, component, this));
        }
        return all;
    }

    /** Automata written here, those in an {@code implementation} included. */
    public List<AutomatonSymbol> ownAutomata() {
        return ownAutomata.get();
    }

    /** I/O tables written here. */
    public List<TableSymbol> ownTables() {
        return ownTables.get();
    }

    /**
     * The automata that hold for it: its own; where it has no behaviour of its own, those of the
     * nearest ancestor that has.
     */
    public List<AutomatonSymbol> automata() {
        return behaviourOwner().ownAutomata();
    }

    /** The tables that hold for it, by the rule of {@link #automata}. */
    public List<TableSymbol> tables() {
        return behaviourOwner().ownTables();
    }

    /** The component whose behaviour holds for this one. */
    public ComponentSymbol behaviourOwner() {
        for (ComponentSymbol component : lineage()) {
            if (!component.ownAutomata().isEmpty() || !component.ownTables().isEmpty()) {
                return component;
            }
        }
        return this;
    }

    /** Whether connectors make its behaviour: between parts, or straight from port to port. */
    public boolean isDecomposed() {
        return !instances().isEmpty() || !connectors().isEmpty();
    }

    /** Whether it steps once per event instead of once per slice. */
    public boolean isEventDriven() {
        return Profiles.eventDriven(this).orElse(timing().eventDriven());
    }

    /** All instances: inherited, declared, and those made for inner components. */
    public List<InstanceSymbol> instances() {
        return instances.get().all();
    }

    /** The instances that this component adds to the inherited ones. */
    public List<InstanceSymbol> ownInstances() {
        return ownInstances.get();
    }

    public Optional<InstanceSymbol> instance(String name) {
        return instances.get().named(name);
    }

    /**
     * All connections, one per target: inherited, explicit, those in the brackets of an instance,
     * and those that {@code autoconnect} makes.
     */
    public List<ConnectorSymbol> connectors() {
        return connectors.get().all();
    }

    /**
     * The first connector to a receiver.
     *
     * @param key {@code port} of this component, or {@code instance.port}
     */
    public Optional<ConnectorSymbol> connectorTo(String key) {
        return connectors.get().to(key);
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

    ValueScope emptyScope() {
        return ValueScope.empty(scope, this::resolveType);
    }

    /** A type as written inside this component: type parameters come first. */
    public Resolution<TypeSymbol> resolveType(TypeReference reference) {
        return TypeReferences.resolve(reference, name -> ComponentNames.type(this, name));
    }

    /** A component named inside this one: inner components, also of those around, come first. */
    public Resolution<ComponentSymbol> resolveComponent(QualifiedName name) {
        return ComponentNames.component(this, name);
    }

    @Override
    public String toString() {
        return qualifiedName;
    }
}
