package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.model.Variable;

import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** What names mean in the expressions of one automaton of one instance. */
public final class Scope {
    private static final Value[] NOTHING = {};

    private final Map<String, Integer> ports = new HashMap<>();
    private final Map<String, Integer> variables = new HashMap<>();
    private final Map<String, Value> fixed = new HashMap<>();
    private final Map<String, Value> parameters = new HashMap<>();

    private Scope() {}

    /** Knows the messages of some ports, and nothing else. */
    public static Scope ofPorts(List<Port> inputs) {
        Scope scope = new Scope();
        inputs.forEach(port -> scope.ports.put(port.name(), scope.ports.size()));
        return scope;
    }

    /** Knows the first parameters of a component, and no constants. */
    public static Scope ofParameters(List<Parameter> declared, List<Value> arguments) {
        Scope scope = new Scope();
        for (int i = 0; i < arguments.size(); i++) {
            scope.parameters.put(declared.get(i).name(), arguments.get(i));
        }
        return scope;
    }

    /**
     * @param arguments one per parameter of the component
     */
    public Scope(Component component, List<Value> arguments) {
        component.inputs().forEach(port -> ports.put(port.name(), ports.size()));
        List<Parameter> declared = component.parameters();
        if (declared.size() != arguments.size()) {
            throw new IllegalArgumentException(
                    component.qualifiedName()
                            + " takes "
                            + declared.size()
                            + " arguments, not "
                            + arguments.size());
        }
        for (int i = 0; i < declared.size(); i++) {
            parameters.put(declared.get(i).name(), arguments.get(i));
        }
        for (Variable constant : component.constants()) {
            fixed.put(constant.name(), first(component, constant));
        }
    }

    public Scope(Component component, List<Value> arguments, Automaton automaton) {
        this(component, arguments);
        automaton.variables().forEach(v -> variables.put(v.name(), variables.size()));
    }

    /** The same with further variables behind those of the automaton. */
    public Scope with(List<Variable> locals) {
        Scope scope = new Scope();
        scope.ports.putAll(ports);
        scope.variables.putAll(variables);
        scope.fixed.putAll(fixed);
        scope.parameters.putAll(parameters);
        locals.forEach(v -> scope.variables.put(v.name(), scope.variables.size()));
        return scope;
    }

    /** The slot of a variable that is no constant. */
    public int slot(Variable variable) {
        return Objects.requireNonNull(variables.get(variable.name()));
    }

    /**
     * The value that a variable starts with.
     *
     * @throws Fault where it cannot be computed or lies outside of the variable's range
     */
    public Value first(Component component, Variable variable) {
        try {
            return Effect.inRange(variable.name(), variable.type(), constant(variable.initial()));
        } catch (Fault fault) {
            throw fault.in(Fault.place(component, variable));
        }
    }

    /** The value of an expression that reads neither ports nor variables. */
    @SuppressWarnings("NullAway") // what reads no port is defined
    public Value constant(Expression expression) {
        return value(expression, NOTHING);
    }

    /**
     * The value of an expression that reads no variables; null where it is undefined.
     *
     * @param messages by position of the port, null for silence
     * @throws Fault where it cannot be computed
     */
    public @Nullable Value value(Expression expression, Value[] messages) {
        return Evaluation.compile(expression, this).evaluate(messages, NOTHING);
    }

    /**
     * Whether a condition that reads no variables is true.
     *
     * @param messages by position of the port, null for silence
     * @throws Fault where it cannot be computed
     */
    public boolean isTrue(Expression condition, Value[] messages) {
        return Evaluation.compile(condition, this).isTrue(messages, NOTHING);
    }

    /** The expression with values in the place of all names but those of ports. */
    public Expression reduced(Expression expression, Value[] values) {
        return expression.rewritten(leaf -> reducedLeaf(leaf, values));
    }

    @SuppressWarnings("NullAway") // names that are read have values
    private Expression reducedLeaf(Expression leaf, Value[] values) {
        if (leaf instanceof Expression.ParameterRead read) {
            return new Expression.Constant(parameter(read.parameter()), read.type(), read.span());
        }
        if (leaf instanceof Expression.VariableRead read) {
            int slot = variable(read.variable());
            Value value = slot < 0 ? constantOf(read.variable()) : values[slot];
            return new Expression.Constant(value, read.type(), read.span());
        }
        return leaf;
    }

    public int port(Port port) {
        Integer index = ports.get(port.name());
        if (index == null) {
            throw new IllegalArgumentException(port.name() + " is not an input port");
        }
        return index;
    }

    /** Null where only the first parameters are known. */
    @Nullable Value parameter(Parameter parameter) {
        return parameters.get(parameter.name());
    }

    /** The slot of a variable of the automaton, or -1 for a constant of the component. */
    int variable(Variable variable) {
        return variables.getOrDefault(variable.name(), -1);
    }

    /** Whether an expression reads a variable of the automaton. */
    boolean isVariable(Expression e) {
        return e instanceof Expression.VariableRead read && variable(read.variable()) >= 0;
    }

    /** Null where the constant has no value yet. */
    @Nullable Value constantOf(Variable variable) {
        return fixed.get(variable.name());
    }
}
