package arcomat.analysis.game.controller;

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
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.SmallType;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** What a port carries, for some of its kinds of messages: a match, or else a guard. */
final class MessageCondition {
    /** A type of so few values that those left are easier to read than those left out. */
    private static final int EASILY_LISTED = 8;

    /** So many numbers are listed rather than compared. */
    private static final int FEW = 3;

    private final Port port;
    private final PortAbstraction look;
    private final List<Value> present = new ArrayList<>();
    private final List<Value> wanted = new ArrayList<>();
    private boolean absentWanted;

    /** What is no number, if it is told apart from others: it has no place in their order. */
    private final boolean noNumberPossible;

    private boolean noNumberWanted;

    /**
     * @param samples of all kinds
     * @param group positions of those that are wanted; not all
     */
    MessageCondition(Port port, PortAbstraction look, List<Value> samples, int[] group) {
        this.port = port;
        this.look = look;
        this.noNumberPossible = samples.stream().anyMatch(MessageCondition::isNoNumber);
        samples.stream()
                .filter(sample -> sample != null && !isNoNumber(sample))
                .sorted()
                .forEach(present::add);
        for (int position : group) {
            Value sample = samples.get(position);
            if (sample == null) {
                absentWanted = true;
            } else if (isNoNumber(sample)) {
                noNumberWanted = true;
            } else {
                wanted.add(sample);
            }
        }
        wanted.sort(Comparator.naturalOrder());
    }

    private static boolean isNoNumber(Value sample) {
        return sample instanceof Value.RealValue real && Double.isNaN(real.value());
    }

    /** The condition as an item of an input block, where it can be one. */
    Optional<Match> match() {
        if (wanted.isEmpty() && !noNumberWanted) {
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
        boolean numbers = wanted.size() == present.size();
        if (numbers && noNumberWanted == noNumberPossible) {
            return Optional.of(new Present());
        }
        if (numbers || noNumberWanted) {
            return Optional.empty();
        }
        if (isOrdered() && port.type() instanceof Type.IntegerType) {
            return few(intervals()).map(few -> new OneOf(constants(few)));
        }
        return wanted.stream().allMatch(this::isExact)
                ? Optional.of(new OneOf(constants(wanted)))
                : listed().map(all -> new OneOf(constants(all)));
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

    @SuppressWarnings("NullAway") // some messages are wanted, and some are not
    private Expression comparison() {
        if (wanted.size() == present.size()) {
            return isNumber();
        }
        if (isOrdered()) {
            Expression any = noNumberWanted ? not(isNumber()) : null;
            for (Interval interval : intervals()) {
                Expression inside = inside(interval);
                any = any == null ? inside : binary(BinaryOperator.OR, any, inside);
            }
            return any;
        }
        Expression all = null;
        for (Value value : present) {
            if (!wanted.contains(value)) {
                all = and(all, compare(BinaryOperator.NOT_EQUAL, value));
            }
        }
        return all;
    }

    /** Neighbouring samples, by their positions. */
    private List<Interval> intervals() {
        List<Interval> intervals = new ArrayList<>();
        int start = -1;
        for (int i = 0; i <= present.size(); i++) {
            boolean inside = i < present.size() && wanted.contains(present.get(i));
            if (inside && start < 0) {
                start = i;
            } else if (!inside && start >= 0) {
                intervals.add(new Interval(start, i - 1));
                start = -1;
            }
        }
        return intervals;
    }

    private record Interval(int first, int last) {}

    /** All whole numbers of some intervals, if they are few. */
    private Optional<List<Value>> few(List<Interval> intervals) {
        List<Value> values = new ArrayList<>();
        for (Interval interval : intervals) {
            long low = low(interval.first);
            long high = high(interval.last);
            if (high - low < 0 || high - low >= FEW - values.size()) {
                return Optional.empty();
            }
            for (long number = low; number <= high; number++) {
                values.add(new Value.IntegerValue(number));
            }
        }
        return Optional.of(values);
    }

    /** The least whole number that a sample stands for. */
    private long low(int sample) {
        if (isExact(present.get(sample))) {
            return number(sample);
        }
        return sample == 0 ? ((Type.IntegerType) port.type()).low() : number(sample - 1) + 1;
    }

    private long high(int sample) {
        if (isExact(present.get(sample))) {
            return number(sample);
        }
        boolean last = sample == present.size() - 1;
        return last ? ((Type.IntegerType) port.type()).high() : number(sample + 1) - 1;
    }

    private long number(int sample) {
        return ((Value.IntegerValue) present.get(sample)).value();
    }

    @SuppressWarnings("NullAway") // an interval has an end on one side at least
    private Expression inside(Interval interval) {
        Value low = present.get(interval.first);
        Value high = present.get(interval.last);
        if (interval.first == interval.last && isExact(low)) {
            return compare(BinaryOperator.EQUAL, low);
        }
        Expression inside = null;
        if (interval.first > 0) {
            inside =
                    isExact(low)
                            ? compare(BinaryOperator.GREATER_OR_EQUAL, low)
                            : compare(BinaryOperator.GREATER, present.get(interval.first - 1));
        }
        if (interval.last < present.size() - 1) {
            Expression below =
                    isExact(high)
                            ? compare(BinaryOperator.LESS_OR_EQUAL, high)
                            : compare(BinaryOperator.LESS, present.get(interval.last + 1));
            inside = and(inside, below);
        }
        return inside;
    }

    private Expression compare(BinaryOperator operator, Value value) {
        return binary(
                operator,
                new Expression.PortRead(port, port.span()),
                constants(List.of(value)).get(0));
    }

    /** What is no number is neither less nor greater than one, nor equal to it. */
    private Expression isNumber() {
        Value some = ((Compared) look).values().get(0);
        return binary(
                BinaryOperator.OR,
                compare(BinaryOperator.LESS_OR_EQUAL, some),
                compare(BinaryOperator.GREATER, some));
    }

    private static Expression not(Expression condition) {
        return new Expression.Unary(
                Expression.UnaryOperator.NOT, condition, condition.type(), condition.span());
    }

    private List<Expression> constants(List<Value> values) {
        return values.stream()
                .<Expression>map(v -> new Expression.Constant(v, port.type(), port.span()))
                .toList();
    }

    /**
     * @param left null for what is always true
     */
    static Expression and(@Nullable Expression left, Expression right) {
        return left == null ? right : binary(BinaryOperator.AND, left, right);
    }

    private static Expression binary(BinaryOperator operator, Expression left, Expression right) {
        return new Expression.Binary(operator, left, right, new Type.BooleanType(), left.span());
    }
}
