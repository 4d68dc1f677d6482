package arcomat.analysis.game;

import arcomat.analysis.engine.SmallType;
import arcomat.model.Automaton.Absent;
import arcomat.model.Automaton.Match;
import arcomat.model.Automaton.OneOf;
import arcomat.model.Automaton.Pattern;
import arcomat.model.Automaton.Present;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.Attention.Compared;
import arcomat.semantics.Attention.Look;
import arcomat.semantics.ValueOrder;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What a port carries, for some of its kinds of messages: a match, or else a guard. */
final class Condition {
    /** A type of so few values that those left are easier to read than those left out. */
    private static final int EASILY_LISTED = 8;

    private final Port port;
    private final Look look;
    private final List<Value> present = new ArrayList<>();
    private final List<Value> wanted = new ArrayList<>();
    private boolean absentWanted;

    /**
     * @param samples of all kinds
     * @param group positions of those that are wanted; not all
     */
    Condition(Port port, Look look, List<Value> samples, int[] group) {
        this.port = port;
        this.look = look;
        samples.stream()
                .filter(sample -> sample != null)
                .sorted(ValueOrder.NATURAL)
                .forEach(present::add);
        for (int position : group) {
            Value sample = samples.get(position);
            if (sample == null) {
                absentWanted = true;
            } else {
                wanted.add(sample);
            }
        }
        wanted.sort(ValueOrder.NATURAL);
    }

    /** The condition as an item of an input block, where it can be one. */
    Optional<Match> match() {
        if (wanted.isEmpty()) {
            return Optional.of(new Match(port, new Absent()));
        }
        return absentWanted ? Optional.empty() : pattern().map(p -> new Match(port, p));
    }

    /** The condition as a guard. */
    Expression guard() {
        Expression message =
                pattern()
                        .<Expression>map(p -> new Expression.PortMatches(port, p, port.span()))
                        .orElseGet(this::comparison);
        return absentWanted
                ? binary(
                        BinaryOperator.OR,
                        new Expression.PortMatches(port, new Absent(), port.span()),
                        message)
                : message;
    }

    /** Of the messages that are wanted. */
    private Optional<Pattern> pattern() {
        if (wanted.size() == present.size()) {
            return Optional.of(new Present());
        }
        List<Value> values = new ArrayList<>();
        for (Value value : wanted) {
            if (!isExact(value)) {
                return listed().map(all -> new OneOf(constants(all)));
            }
            values.add(value);
        }
        boolean range = isOrdered() && values.size() > 2;
        return range ? Optional.empty() : Optional.of(new OneOf(constants(values)));
    }

    /** Whether a sample stands for itself alone. */
    private boolean isExact(Value sample) {
        return !(look instanceof Compared compared) || compared.values().contains(sample);
    }

    private boolean isOrdered() {
        return look instanceof Compared compared
                ? compared.ordered()
                : port.type() instanceof Type.IntegerType;
    }

    /** All values that are wanted, those included that a sample stands for. */
    private Optional<List<Value>> listed() {
        return SmallType.values(port.type())
                .filter(all -> all.size() <= EASILY_LISTED && !isOrdered())
                .map(
                        all ->
                                all.stream()
                                        .filter(v -> wanted.contains(isExact(v) ? v : other()))
                                        .toList());
    }

    /** The sample of what is not compared with. */
    private Value other() {
        return present.stream().filter(each -> !isExact(each)).findFirst().orElseThrow();
    }

    private Expression comparison() {
        if (isOrdered()) {
            return ranges();
        }
        Expression all = null;
        for (Value value : present) {
            if (!wanted.contains(value)) {
                all = and(all, compare(BinaryOperator.NOT_EQUAL, value));
            }
        }
        return all;
    }

    private Expression ranges() {
        Expression any = null;
        int start = -1;
        for (int i = 0; i <= present.size(); i++) {
            boolean inside = i < present.size() && wanted.contains(present.get(i));
            if (inside && start < 0) {
                start = i;
            } else if (!inside && start >= 0) {
                Expression range = range(start, i - 1);
                any = any == null ? range : binary(BinaryOperator.OR, any, range);
                start = -1;
            }
        }
        return any;
    }

    private Expression range(int first, int last) {
        Value low = present.get(first);
        Value high = present.get(last);
        if (first == last && isExact(low)) {
            return compare(BinaryOperator.EQUAL, low);
        }
        Expression range = null;
        if (first > 0) {
            range =
                    isExact(low)
                            ? compare(BinaryOperator.GREATER_OR_EQUAL, low)
                            : compare(BinaryOperator.GREATER, present.get(first - 1));
        }
        if (last < present.size() - 1) {
            range =
                    and(
                            range,
                            isExact(high)
                                    ? compare(BinaryOperator.LESS_OR_EQUAL, high)
                                    : compare(BinaryOperator.LESS, present.get(last + 1)));
        }
        return range;
    }

    private Expression compare(BinaryOperator operator, Value value) {
        return binary(
                operator,
                new Expression.PortRead(port, port.span()),
                constants(List.of(value)).get(0));
    }

    private List<Expression> constants(List<Value> values) {
        return values.stream()
                .<Expression>map(v -> new Expression.Constant(v, port.type(), port.span()))
                .toList();
    }

    /**
     * @param left null for what is always true
     */
    static Expression and(Expression left, Expression right) {
        return left == null ? right : binary(BinaryOperator.AND, left, right);
    }

    private static Expression binary(
            BinaryOperator operator, Expression left, Expression right) {
        return new Expression.Binary(operator, left, right, new Type.BooleanType(), left.span());
    }
}
