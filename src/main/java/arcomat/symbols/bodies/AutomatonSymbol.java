package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.symbols.signatures.Timing;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Element;
import arcomat.tree.Name;
import arcomat.tree.Statement;
import arcomat.tree.Stereotype;
import arcomat.tree.Unit;
import arcomat.tree.Variable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** An automaton with its states, variables, transitions and the interface it works on. */
public final class AutomatonSymbol {
    /** A state; {@code index} counts the declarations from 0. */
    public record StateSymbol(AutomatonElement.State node, int index) {
        public String name() {
            return node.name().text();
        }

        public Span nameSpan() {
            return node.name().span();
        }
    }

    /**
     * One initial state. A clause that names several states gives several, with the same items.
     *
     * @param node the whole clause
     * @param state empty where no such state is declared
     * @param items those of statements, too
     * @param actions where it has statements
     */
    public record InitialSymbol(
            AutomatonElement.Initial node,
            Name name,
            Optional<StateSymbol> state,
            List<ItemSymbol> items,
            Optional<ActionSymbol> actions) {
        public InitialSymbol {
            items = List.copyOf(items);
        }
    }

    private final Automaton node;
    private final UnitScope unitScope;
    private final Optional<ComponentSymbol> component;
    private final ValueScope constants;
    private final Lazy<List<PortSymbol>> declaredPorts = new Lazy<>(this::makePorts);
    private final Lazy<List<VariableSymbol>> variables = new Lazy<>(this::makeVariables);
    private final Lazy<List<VariableSymbol>> fields = new Lazy<>(this::makeFields);
    private final Lazy<Map<String, StateSymbol>> statesByName = new Lazy<>(this::firstByName);
    private final Lazy<ItemScope> itemScope = new Lazy<>(this::makeItemScope);
    private final Lazy<List<StateSymbol>> states = new Lazy<>(this::makeStates);
    private final Lazy<List<InitialSymbol>> initials = new Lazy<>(this::makeInitials);
    private final Lazy<List<TransitionSymbol>> transitions = new Lazy<>(this::makeTransitions);

    private AutomatonSymbol(
            Automaton node, UnitScope unitScope, Optional<ComponentSymbol> component) {
        this.node = node;
        this.unitScope = unitScope;
        this.component = component;
        this.constants =
                component
                        .map(ComponentSymbol::constantScope)
                        .orElseGet(() -> ValueScope.empty(unitScope, unitScope::type));
    }

    static AutomatonSymbol embedded(Automaton node, ComponentSymbol component) {
        return new AutomatonSymbol(node, component.unitScope(), Optional.of(component));
    }

    public static AutomatonSymbol bare(Automaton node, UnitScope unitScope) {
        return new AutomatonSymbol(node, unitScope, Optional.empty());
    }

    public Automaton node() {
        return node;
    }

    public Unit unit() {
        return unitScope.unit();
    }

    /** The component it is written in; empty for a bare automaton. */
    public Optional<ComponentSymbol> component() {
        return component;
    }

    /** Empty where it has no name. */
    public String name() {
        return node.name().map(Name::text).orElse("");
    }

    /** The value of a stereotype of the automaton, as {@code completion} or {@code omitted}. */
    public Optional<String> stereotype(String stereotype) {
        return Stereotype.find(node.stereotypes(), stereotype)
                .flatMap(Stereotype::value)
                .map(Name::text);
    }

    // ---- interface ------------------------------------------------------------------------

    /** Ports of the component, or inputs and outputs of a bare automaton. */
    public List<PortSymbol> ports() {
        return component.map(ComponentSymbol::ports).orElseGet(this::declaredPorts);
    }

    /** Inputs and outputs that the automaton itself declares: right in bare automata only. */
    public List<PortSymbol> declaredPorts() {
        return declaredPorts.get();
    }

    /** Variables that are declared in the automaton itself. */
    public List<VariableSymbol> variables() {
        return variables.get();
    }

    /**
     * Variables of the component that this automaton writes somewhere, and so keeps as its own.
     * Those that it only reads are constants.
     */
    public List<VariableSymbol> fields() {
        return fields.get();
    }

    /** All that it remembers from step to step. */
    public List<VariableSymbol> memory() {
        return Stream.concat(fields().stream(), variables().stream()).toList();
    }

    private List<PortSymbol> makePorts() {
        List<PortSymbol> all = new ArrayList<>();
        for (var declaration : node.elements(AutomatonElement.Declaration.class)) {
            if (declaration.kind() != AutomatonElement.Kind.VARIABLE) {
                declaration.variables().forEach(v -> all.add(port(declaration, v)));
            }
        }
        return List.copyOf(all);
    }

    private PortSymbol port(AutomatonElement.Declaration declaration, Variable variable) {
        boolean input = declaration.kind() == AutomatonElement.Kind.INPUT;
        return new PortSymbol(
                variable.name().text(),
                variable.name().span(),
                false,
                input ? Element.Direction.IN : Element.Direction.OUT,
                declaration.type(),
                constants.type(declaration.type()),
                List.of(),
                Timing.DEFAULT.delay());
    }

    private List<VariableSymbol> makeVariables() {
        List<VariableSymbol> all = new ArrayList<>();
        for (var declaration : node.elements(AutomatonElement.Declaration.class)) {
            if (declaration.kind() == AutomatonElement.Kind.VARIABLE) {
                Resolution<TypeSymbol> type = constants.type(declaration.type());
                for (Variable variable : declaration.variables()) {
                    all.add(
                            new VariableSymbol(
                                    VariableSymbol.Kind.AUTOMATON,
                                    variable,
                                    type,
                                    ExpressionTyping.at(constants)));
                }
            }
        }
        return List.copyOf(all);
    }

    /** A field that has the name of a port or of a variable here is hidden by that. */
    private List<VariableSymbol> makeFields() {
        if (component.isEmpty()) {
            return List.of();
        }
        Set<String> written = AssignedNames.in(node);
        ports().forEach(port -> written.remove(port.name()));
        variables().forEach(variable -> written.remove(variable.name()));
        return component.get().signature().variables().stream()
                .filter(variable -> written.remove(variable.name()))
                .toList();
    }

    /** What guards and item values may name: ports, variables, constants, parameters. */
    public ValueScope scope() {
        return itemScope.get().values();
    }

    /** A variable that is wrongly named like a port does not hide it: others rely on the port. */
    private ItemScope makeItemScope() {
        List<PortSymbol> ports = ports();
        ValueScope values = constants.with(variables()).with(ports);
        return new ItemScope(ports, memory(), values);
    }

    // ---- states and transitions -----------------------------------------------------------

    /** The states in text order, duplicates included. */
    public List<StateSymbol> states() {
        return states.get();
    }

    public Optional<StateSymbol> state(String stateName) {
        return Optional.ofNullable(statesByName.get().get(stateName));
    }

    /** One entry per state that is named behind {@code initial}. */
    public List<InitialSymbol> initials() {
        return initials.get();
    }

    public List<TransitionSymbol> transitions() {
        return transitions.get();
    }

    private List<StateSymbol> makeStates() {
        List<StateSymbol> all = new ArrayList<>();
        for (AutomatonElement each : node.elements()) {
            for (AutomatonElement.State state : declaredBy(each)) {
                all.add(new StateSymbol(state, all.size()));
            }
        }
        return List.copyOf(all);
    }

    private static List<AutomatonElement.State> declaredBy(AutomatonElement element) {
        if (element instanceof AutomatonElement.States list) {
            return list.states();
        }
        return element instanceof AutomatonElement.Initial initial ? initial.declared() : List.of();
    }

    private Map<String, StateSymbol> firstByName() {
        Map<String, StateSymbol> map = new HashMap<>();
        states().forEach(state -> map.putIfAbsent(state.name(), state));
        return map;
    }

    private List<InitialSymbol> makeInitials() {
        List<InitialSymbol> all = new ArrayList<>();
        for (AutomatonElement.Initial initial : node.elements(AutomatonElement.Initial.class)) {
            Optional<ActionSymbol> actions = actions(initial.actions(), Side.INITIAL);
            List<ItemSymbol> items =
                    actions.map(ActionSymbol::items)
                            .orElseGet(() -> itemScope().items(initial.output(), Side.INITIAL));
            for (Name state : initial.states()) {
                all.add(new InitialSymbol(initial, state, state(state.text()), items, actions));
            }
        }
        return List.copyOf(all);
    }

    private List<TransitionSymbol> makeTransitions() {
        return node.elements(AutomatonElement.Transition.class).stream()
                .map(t -> new TransitionSymbol(this, t))
                .toList();
    }

    Optional<ActionSymbol> actions(Optional<Statement.Sequence> statements, Side side) {
        return statements.map(each -> new ActionTyping(itemScope(), side).sequence(each));
    }

    ItemScope itemScope() {
        return itemScope.get();
    }

    @Override
    public String toString() {
        return name();
    }
}
