package arcomat.laws.naive;

import arcomat.laws.naive.NaiveAutomata.Place;
import arcomat.laws.naive.NaiveBehaviour.Move;
import arcomat.laws.naive.NaiveBehaviour.State;
import arcomat.laws.naive.NaiveValues.Wrong;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Invariant;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/** The first slice in which an invariant is not true, by trying all that may happen. */
public final class NaiveInvariant {
    /** Before the first slice. */
    public static final int AT_THE_START = -1;

    private static final int MOST_STATES = 400;

    private final Component component;
    private final Invariant invariant;
    private final List<Value> pool;
    private final NaiveBehaviour behaviour;
    private final List<Automaton> automata;

    /**
     * @param first the first slice that breaks it; empty if none was found
     * @param all whether all messages and values were tried
     */
    public record Answer(OptionalInt first, boolean all) {}

    private NaiveInvariant(Component component, Invariant invariant, List<Value> pool) {
        this.component = component;
        this.invariant = invariant;
        this.pool = pool;
        this.automata = component.isComposite() ? List.of() : component.automata();
        this.behaviour = NaiveBehaviour.of(component, automata, pool, true);
    }

    /**
     * @param pool messages of large types that are tried
     * @param slices so many at most
     * @return empty where there is too much to try
     */
    public static Optional<Answer> ask(
            Component component, Invariant invariant, List<Value> pool, int slices) {
        try {
            return Optional.of(new NaiveInvariant(component, invariant, pool).ask(slices));
        } catch (NaiveComparison.TooMuch | UnsupportedOperationException unknown) {
            return Optional.empty();
        }
    }

    private Answer ask(int slices) {
        Set<State> met = new HashSet<>();
        behaviour.starts().moves().forEach(move -> met.add(move.next()));
        if (isAboutVariables() && met.stream().anyMatch(s -> isBroken(Map.of(), s))) {
            return new Answer(OptionalInt.of(AT_THE_START), isSmall());
        }
        List<State> level = new ArrayList<>(met);
        List<Map<String, Value>> letters = letters();
        for (int slice = 0; slice < slices && !level.isEmpty(); slice++) {
            List<State> next = new ArrayList<>();
            for (State state : level) {
                for (Map<String, Value> letter : letters) {
                    for (Move move : behaviour.moves(state, letter).moves()) {
                        if (isBroken(seen(state, letter, move), move.next())) {
                            return new Answer(OptionalInt.of(slice), isSmall());
                        }
                        if (met.add(move.next())) {
                            next.add(move.next());
                        }
                    }
                }
            }
            if (met.size() > MOST_STATES) {
                throw new NaiveComparison.TooMuch();
            }
            level = next;
        }
        return new Answer(OptionalInt.empty(), isSmall());
    }

    private boolean isSmall() {
        return NaiveQuestion.ports(component).stream().allMatch(p -> NaiveValues.isSmall(p.type()))
                && automata.stream()
                        .flatMap(each -> each.variables().stream())
                        .allMatch(each -> NaiveValues.isSmall(each.type()));
    }

    private List<Map<String, Value>> letters() {
        List<Map<String, Value>> letters = List.of(Map.of());
        for (Port port : component.inputs()) {
            List<Map<String, Value>> longer = port.total() ? new ArrayList<>() : copy(letters);
            for (Map<String, Value> letter : letters) {
                for (Value value : NaiveValues.all(port.type(), pool)) {
                    Map<String, Value> with = new HashMap<>(letter);
                    with.put(port.name(), value);
                    longer.add(with);
                }
            }
            letters = longer;
        }
        return letters;
    }

    private static List<Map<String, Value>> copy(List<Map<String, Value>> letters) {
        return new ArrayList<>(letters);
    }

    private Map<String, Value> seen(State before, Map<String, Value> letter, Move move) {
        Map<String, Value> seen = new HashMap<>(letter);
        for (Port port : component.outputs()) {
            String name = port.name();
            Slot slot =
                    !behaviour.isConnected(name)
                            ? Slot.SILENCE
                            : behaviour.isLate(name)
                                    ? behaviour.due(before, name)
                                    : move.outputs().getOrDefault(name, Slot.SILENCE);
            seen.put(name, slot.message());
        }
        return seen;
    }

    private boolean isAboutVariables() {
        return component.ports().stream()
                .noneMatch(
                        port ->
                                invariant
                                        .condition()
                                        .toString()
                                        .contains("port=" + port.name() + ","));
    }

    /** Of an automaton in chaos nobody knows the variables. */
    private boolean isBroken(Map<String, Value> seen, State after) {
        List<Map<String, Value>> all = new ArrayList<>(List.of(Map.of()));
        for (int i = 0; i < automata.size(); i++) {
            Place place = after.parts().get(0).get(i);
            for (Variable variable : automata.get(i).variables()) {
                List<Value> values =
                        place.equals(Place.CHAOS)
                                ? NaiveValues.all(variable.type(), pool)
                                : List.of(place.variables().get(variable.name()));
                List<Map<String, Value>> longer = new ArrayList<>();
                for (Map<String, Value> each : all) {
                    for (Value value : values) {
                        Map<String, Value> with = new HashMap<>(each);
                        with.put(variable.name(), value);
                        longer.add(with);
                    }
                }
                all = longer;
            }
        }
        return all.stream()
                .anyMatch(
                        variables ->
                                !Boolean.TRUE.equals(
                                        truth(
                                                invariant.condition(),
                                                new NaiveValues(seen, variables))));
    }

    /** Null where it is undefined: a message is missing, or it divides by zero. */
    private static Boolean truth(Expression e, NaiveValues values) {
        if (e instanceof Expression.Binary binary && binary.operator() == BinaryOperator.AND) {
            return and(truth(binary.left(), values), truth(binary.right(), values));
        }
        if (e instanceof Expression.Binary binary && binary.operator() == BinaryOperator.OR) {
            return not(and(not(truth(binary.left(), values)), not(truth(binary.right(), values))));
        }
        if (e instanceof Expression.Binary binary && binary.operator() == BinaryOperator.IMPLIES) {
            return not(and(truth(binary.left(), values), not(truth(binary.right(), values))));
        }
        if (e instanceof Expression.Unary unary && unary.type() instanceof Type.BooleanType) {
            return not(truth(unary.operand(), values));
        }
        try {
            Value value = values.of(e);
            return value == null ? null : ((Value.BooleanValue) value).value();
        } catch (Wrong divisionByZero) {
            return null;
        }
    }

    private static Boolean and(Boolean left, Boolean right) {
        if (Boolean.FALSE.equals(left) || Boolean.FALSE.equals(right)) {
            return false;
        }
        return left == null || right == null ? null : Boolean.TRUE;
    }

    private static Boolean not(Boolean value) {
        return value == null ? null : Boolean.valueOf(!value);
    }
}
