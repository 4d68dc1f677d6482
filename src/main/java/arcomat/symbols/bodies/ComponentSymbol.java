package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.ComponentDeclaration;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.symbols.signatures.BehaviourReader.Reading;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Automaton;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Stereotype;
import arcomat.tree.TypeReference;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * A component type, top-level or inner, with what stands in its body: parts, connectors, automata.
 * What is inherited comes before what is declared here; "own" leaves inherited things out. Where
 * something is declared twice, look-ups by name give the first.
 */
public final class ComponentSymbol {
    private final Signature signature;
    private final Function<Signature, ComponentSymbol> components;
    private final BehaviourReader reader;
    private final Lazy<Map<Behaviour.Foreign, Reading>> readings = new Lazy<>(this::makeReadings);
    private final Lazy<List<AutomatonSymbol>> ownAutomata = new Lazy<>(this::makeAutomata);
    private final Lazy<List<ComponentSymbol>> lineage = new Lazy<>(this::makeLineage);
    private final Lazy<List<InvariantSymbol>> ownInvariants = new Lazy<>(() -> invariantsOf(this));
    private final Lazy<List<InvariantSymbol>> invariants = new Lazy<>(this::makeInvariants);
    private final Lazy<List<InstanceSymbol>> ownInstances =
            new Lazy<>(() -> Instances.declaredIn(this));
    private final Lazy<Boolean> eventDriven = new Lazy<>(this::computeEventDriven);
    private final Lazy<Instances> instances = new Lazy<>(() -> Instances.of(this));
    private final Lazy<Connectors> connectors = new Lazy<>(() -> Connectors.of(this));

    /**
     * @param components all of them, this one included
     * @param reader of behaviours that are not read yet
     */
    public ComponentSymbol(
            Signature signature,
            Function<Signature, ComponentSymbol> components,
            BehaviourReader reader) {
        this.signature = signature;
        this.components = components;
        this.reader = reader;
    }

    private List<AutomatonSymbol> makeAutomata() {
        return node().elements(Behaviour.class).stream()
                .flatMap(behaviour -> automata(behaviour).stream())
                .map(automaton -> AutomatonSymbol.embedded(automaton, this))
                .toList();
    }

    private List<Automaton> automata(Behaviour behaviour) {
        Reading reading = behaviour instanceof Behaviour.Foreign ? readings().get(behaviour) : null;
        return reading == null ? behaviour.automata() : reading.automaton().stream().toList();
    }

    private Map<Behaviour.Foreign, Reading> makeReadings() {
        Map<Behaviour.Foreign, Reading> all = new LinkedHashMap<>();
        for (Behaviour.Foreign each : node().elements(Behaviour.Foreign.class)) {
            if (each.automata().isEmpty()) {
                reader.read(each, signature).ifPresent(reading -> all.put(each, reading));
            }
        }
        return Collections.unmodifiableMap(all);
    }

    // ---- what it is -----------------------------------------------------------------------

    /** What others can see of it. */
    public Signature signature() {
        return signature;
    }

    ComponentSymbol of(Signature other) {
        return components.apply(other);
    }

    /** Where it stands, and which of its configurations it is. */
    public ComponentDeclaration declaration() {
        return signature.declaration();
    }

    public Component node() {
        return signature.node();
    }

    public Unit unit() {
        return signature.unit();
    }

    /** What names in its file reach. */
    public UnitScope unitScope() {
        return signature.declaration().unitScope();
    }

    public String name() {
        return signature.name();
    }

    public Span nameSpan() {
        return signature.nameSpan();
    }

    /** {@code package.Outer.Inner}. */
    public String qualifiedName() {
        return signature.qualifiedName();
    }

    public Optional<ComponentSymbol> enclosing() {
        return signature.enclosing().map(components);
    }

    public List<ComponentSymbol> innerComponents() {
        return signature.innerComponents().stream().map(components).toList();
    }

    public List<Stereotype> stereotypes() {
        return signature.stereotypes();
    }

    /** Without behaviour in the model: {@code <<platform>>} or {@code abstract}. */
    public boolean isPlatform() {
        return signature.isPlatform();
    }

    /** Whether a component further up does not resolve, so that ports may be missing. */
    public boolean lacksAncestor() {
        List<Signature> lineage = signature().lineage();
        return lineage.get(lineage.size() - 1)
                .superComponent()
                .filter(above -> above.component().isEmpty())
                .isPresent();
    }

    /** This component and those above it, nearest first; ends before one would come again. */
    public List<ComponentSymbol> lineage() {
        return lineage.get();
    }

    private List<ComponentSymbol> makeLineage() {
        return signature.lineage().stream().map(components).toList();
    }

    // ---- members --------------------------------------------------------------------------

    /** All ports, inherited ones first. A port declared again appears again. */
    public List<PortSymbol> ports() {
        return signature.ports();
    }

    public Optional<PortSymbol> port(String name) {
        return signature.port(name);
    }

    /** All parameters in the order of arguments. */
    public List<ParameterSymbol> parameters() {
        return signature.parameters();
    }

    /** Invariants written here. */
    public List<InvariantSymbol> ownInvariants() {
        return ownInvariants.get();
    }

    /** All that hold for it, inherited ones first. */
    public List<InvariantSymbol> invariants() {
        return invariants.get();
    }

    private List<InvariantSymbol> makeInvariants() {
        List<InvariantSymbol> all = new ArrayList<>();
        for (ComponentSymbol each : lineage()) {
            all.addAll(0, each == this ? ownInvariants() : invariantsOf(each));
        }
        return List.copyOf(all);
    }

    private List<InvariantSymbol> invariantsOf(ComponentSymbol component) {
        Map<String, Integer> numbers = new HashMap<>();
        return component.node().elements(Element.Invariant.class).stream()
                .map(
                        each ->
                                new InvariantSymbol(
                                        each,
                                        component,
                                        this,
                                        numbers.merge(each.name().text(), 1, Integer::sum)))
                .toList();
    }

    /** Automata written here, those in an {@code implementation} included. */
    public List<AutomatonSymbol> ownAutomata() {
        return ownAutomata.get();
    }

    /**
     * What came of behaviours written here whose languages have to know names and types, in the
     * order of the text.
     */
    public Map<Behaviour.Foreign, Reading> readings() {
        return readings.get();
    }

    /** Whether an automaton is what a behaviour written here means, and not what is written. */
    public boolean isMeaning(AutomatonSymbol automaton) {
        return node().elements(Behaviour.class).stream()
                .filter(Behaviour::isMeaning)
                .anyMatch(each -> automata(each).contains(automaton.node()));
    }

    /**
     * The automata that hold for it: its own; where it has no behaviour of its own, those of the
     * nearest ancestor that has.
     */
    public List<AutomatonSymbol> automata() {
        return behaviourOwner().ownAutomata();
    }

    /**
     * The variables of the component that one of its automata writes: with that automaton they
     * change. All others are constants.
     */
    public List<VariableSymbol> fields() {
        return automata().stream().flatMap(each -> each.fields().stream()).distinct().toList();
    }

    /** The component whose behaviour holds for this one. */
    private ComponentSymbol behaviourOwner() {
        for (ComponentSymbol component : lineage()) {
            if (!component.ownAutomata().isEmpty()) {
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
        return eventDriven.get();
    }

    private boolean computeEventDriven() {
        return Parts.eventDriven(this).orElse(signature.timing().eventDriven());
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

    /** What arguments of instances may read: parameters and constants. */
    public ValueScope constantScope() {
        return signature.constantScope();
    }

    /** A type as written inside this component: type parameters come first. */
    public Resolution<TypeSymbol> resolveType(TypeReference reference) {
        return signature.resolveType(reference);
    }

    @Override
    public String toString() {
        return qualifiedName();
    }
}
