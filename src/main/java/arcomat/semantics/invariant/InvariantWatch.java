package arcomat.semantics.invariant;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Invariant;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Conjunction;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.invariant.WatchedComponent.Observer;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * An observer of a component that judges an invariant in every slice: a part without delay that
 * sees what the invariant mentions, and sends a message in each slice in which it is not true.
 * Where a message is missing the invariant is undefined, which is not true; so it is where it
 * divides by zero.
 */
public final class InvariantWatch {
    /** The output of the observer. No name of a model has a blank. */
    public static final String BROKEN = "not true";

    /** The state of the observer. */
    public static final String STATE = "judging";

    /** An input that nothing is connected to: to read it is undefined. */
    private static final String NOTHING = "no message";

    private static final Type BOOLEAN = new Type.BooleanType();

    private final Component watched;
    private final Invariant invariant;
    private final Map<String, Seen> seen = new LinkedHashMap<>();
    private final Expression condition;
    private final Component observer;

    /** What the observer looks at, each on an input of its own. */
    public sealed interface Seen {
        Port input();
    }

    /** A port of the component. */
    public record SeenPort(Port input) implements Seen {}

    /** An output of a part. */
    public record SeenInside(Port input, String part, String port) implements Seen {}

    /** A variable of an automaton, after the step. */
    public record SeenVariable(Port input) implements Seen {}

    /** The verdict on a slice. */
    public enum Truth {
        TRUE,
        FALSE,
        UNDEFINED
    }

    public InvariantWatch(Component watched, Invariant invariant) {
        this.watched = watched;
        this.invariant = invariant;
        this.condition = invariant.condition().rewritten(e -> e.match(new AsSeen()));
        this.observer = observer("", condition, seen());
    }

    /** What the observer asks instead of what the invariant asks. */
    private final class AsSeen implements Expression.SomeCases<Expression> {
        @Override
        public Expression portRead(Expression.PortRead read) {
            return new Expression.PortRead(port(read.port()), read.span());
        }

        @Override
        public Expression portMatches(Expression.PortMatches matches) {
            return new Expression.PortMatches(
                    port(matches.port()), matches.pattern(), matches.span());
        }

        @Override
        public Expression variableRead(Expression.VariableRead read) {
            if (!isKept(read.variable())) {
                return read;
            }
            Port input = input(read.variable().name(), read.variable().type(), true);
            seen.putIfAbsent(input.name(), new SeenVariable(input));
            return new Expression.PortRead(input, read.span());
        }

        @Override
        public Expression binary(Expression.Binary binary) {
            return mayDivideByZero(binary) ? divided(binary) : binary;
        }

        @Override
        public Expression otherwise(Expression e) {
            return e;
        }
    }

    private boolean isKept(Variable variable) {
        return watched.body() instanceof Component.Atomic atomic
                && atomic.automata().stream().anyMatch(a -> a.variables().contains(variable));
    }

    private Port port(Port port) {
        Optional<Port> own = watched.port(port.name());
        boolean total = own.isPresent() && port.total() && (port.isInput() || hasSender(port));
        Port input = input(port.name(), port.type(), total);
        int dot = port.name().indexOf('.');
        seen.putIfAbsent(
                input.name(),
                own.isPresent()
                        ? new SeenPort(input)
                        : new SeenInside(
                                input,
                                port.name().substring(0, dot),
                                port.name().substring(dot + 1)));
        return seen.get(input.name()).input();
    }

    private boolean hasSender(Port output) {
        return !(watched.body() instanceof Component.Composite composite)
                || WatchedComponent.sender(composite, output.name()).isPresent();
    }

    @SuppressWarnings("NullAway") // the port stands nowhere in the text
    private static Port input(String name, Type type, boolean total) {
        return new Port(name, Port.Direction.IN, type, total, 0, false, null);
    }

    private static boolean mayDivideByZero(Expression.Binary binary) {
        return binary.operator().divides() && binary.type() instanceof Type.IntegerType;
    }

    private static Expression divided(Expression.Binary binary) {
        Type type = binary.right().type();
        Expression isZero =
                new Expression.Binary(
                        BinaryOperator.EQUAL,
                        binary.right(),
                        new Expression.Constant(new Value.IntegerValue(0), type, binary.span()),
                        BOOLEAN,
                        binary.span());
        Port nothing = input(NOTHING, binary.type(), false);
        return new Expression.Conditional(
                isZero,
                new Expression.PortRead(nothing, binary.span()),
                binary,
                binary.type(),
                binary.span());
    }

    /**
     * @param mark behind its name, and that of its output
     */
    private Component observer(String mark, Expression condition, List<Seen> seen) {
        List<Port> ports = new ArrayList<>();
        seen.forEach(each -> ports.add(each.input()));
        condition.visit(
                e -> {
                    if (e instanceof Expression.PortRead read
                            && read.port().name().equals(NOTHING)
                            && ports.stream().noneMatch(p -> p.name().equals(NOTHING))) {
                        ports.add(read.port());
                    }
                });
        Port broken =
                new Port(
                        BROKEN + mark,
                        Port.Direction.OUT,
                        BOOLEAN,
                        false,
                        0,
                        false,
                        invariant.span());
        ports.add(broken);
        return watched.like(
                "invariant " + invariant.name() + mark,
                ports,
                new Component.Atomic(List.of(judge(condition, broken))),
                watched.span());
    }

    /** Where the first transition cannot be taken, anything is sent: silence, too, but not only. */
    private Automaton judge(Expression condition, Port broken) {
        Expression isTrue =
                new Expression.Constant(new Value.BooleanValue(true), BOOLEAN, invariant.span());
        List<Automaton.Transition> transitions =
                List.of(
                        transition(condition, List.of()),
                        transition(
                                new Expression.Unary(
                                        Expression.UnaryOperator.NOT,
                                        condition,
                                        BOOLEAN,
                                        condition.span()),
                                List.of(
                                        new Automaton.Send(
                                                broken, new Automaton.Messages(List.of(isTrue))))));
        return new Automaton(
                "",
                Automaton.Completion.OUTPUT,
                Automaton.Omitted.SILENT,
                List.of(STATE),
                List.of(),
                List.of(new Automaton.Initial(0, List.of(), List.of(), invariant.span())),
                transitions,
                invariant.span());
    }

    private Automaton.Transition transition(Expression guard, List<Automaton.Send> sends) {
        return new Automaton.Transition(
                0, 0, Optional.of(guard), List.of(), sends, List.of(), invariant.span());
    }

    /** What the invariant mentions, in the order of the text. */
    public List<Seen> seen() {
        return List.copyOf(seen.values());
    }

    /** Whether it is about variables alone, so that it says something before the first slice. */
    public boolean mentionsNoPort() {
        return seen.values().stream().allMatch(SeenVariable.class::isInstance);
    }

    /** The component with its observer: the same ports, and {@link #BROKEN}. */
    public Component together() {
        return new WatchedComponent(watched, invariant, List.of(new Observer(observer, seen())))
                .together();
    }

    /**
     * The component with an observer for each part of the conjunction that looks at ports of its
     * own: none of them ever speaks if and only if the observer of {@link #together} never does,
     * and each looks at little. A conjunction is true where all of its parts are, else not.
     */
    public Component apart() {
        Map<List<Seen>, Expression> conditions = new LinkedHashMap<>();
        for (Expression each : Conjunction.parts(condition)) {
            conditions.merge(seenIn(each), each, Formulas::and);
        }
        List<Observer> observers = new ArrayList<>();
        conditions.forEach(
                (some, each) -> {
                    String mark = " " + observers.size();
                    observers.add(new Observer(observer(mark, each, some), some));
                });
        return new WatchedComponent(watched, invariant, observers).together();
    }

    private List<Seen> seenIn(Expression part) {
        Set<String> names = part.ports().stream().map(Port::name).collect(Collectors.toSet());
        return seen().stream().filter(each -> names.contains(each.input().name())).toList();
    }

    /** The name of the observer among the parts. */
    public String name() {
        return observer.name();
    }

    /**
     * Judges what was seen.
     *
     * @param arguments one per parameter
     * @param values of what is {@link #seen()}, null for silence
     */
    public Truth judge(List<Value> arguments, List<Value> values) {
        Value[] slots = new Value[observer.inputs().size()];
        for (int i = 0; i < values.size(); i++) {
            slots[i] = values.get(i);
        }
        StepRelation relation = ComponentSemantics.of(observer, arguments).relations().get(0);
        Reaction reaction =
                relation.prospect(relation.starts().get(0).configuration(), Input.of(slots))
                        .reactions()
                        .get(0);
        return truth(reaction.cause());
    }

    /** What the observer's step says. */
    public static Truth truth(Trace.Cause cause) {
        return cause instanceof Trace.Taken taken
                ? taken.index() == 0 ? Truth.TRUE : Truth.FALSE
                : Truth.UNDEFINED;
    }
}
