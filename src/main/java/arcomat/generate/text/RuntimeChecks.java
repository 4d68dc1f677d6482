package arcomat.generate.text;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Interval;
import arcomat.semantics.expression.Presence;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Which operations may go wrong at runtime, by a division by zero or a value out of its range, so
 * that generated code has to look out for it.
 *
 * @param known where variables lie, by name, beside what their types say
 */
public record RuntimeChecks(Map<String, Interval> known) {

    /** Where nothing is known of variables but their types. */
    public static final RuntimeChecks ANYWHERE = new RuntimeChecks(Map.of());

    /** Where a condition holds, and tells between which bounds variables lie. */
    public static RuntimeChecks where(Formula condition) {
        Map<String, Interval> known = new HashMap<>();
        for (Formula conjunct : condition.conjuncts()) {
            if (conjunct instanceof Formula.Test test && test.bounds().isPresent()) {
                Formula.Bounds bounds = test.bounds().get();
                Interval between = Interval.of(bounds.low(), bounds.high());
                known.merge(bounds.number(), between, Interval::within);
            }
        }
        return new RuntimeChecks(known);
    }

    /** Whether computing a value may go wrong, or leave the range of what the value is for. */
    public boolean areNeeded(Expression value, Type wanted) {
        return isNeeded(value, wanted) || dividesAnywhere(value);
    }

    /** Whether computing a condition may go wrong. */
    public static boolean dividesAnywhere(Expression value) {
        return value.contains(e -> e instanceof Expression.Binary binary && isNeeded(binary));
    }

    /** Whether computing what is sent may go wrong. */
    public boolean areNeeded(List<Automaton.Send> sends) {
        return sends.stream()
                .anyMatch(
                        send ->
                                send.emission().values().stream()
                                        .anyMatch(v -> areNeeded(v, send.port().type())));
    }

    /** Whether computing what is assigned may go wrong. */
    public boolean areNeededFor(List<Automaton.Assignment> assignments) {
        return assignments.stream().anyMatch(a -> areNeeded(a.value(), a.variable().type()));
    }

    /** Whether a first value, or what is sent and assigned at the beginning, may go wrong. */
    public static boolean atBeginning(Component component, Automaton automaton) {
        return Stream.concat(component.constants().stream(), automaton.variables().stream())
                        .anyMatch(each -> ANYWHERE.areNeeded(each.initial(), each.type()))
                || automaton.initials().stream()
                        .anyMatch(
                                each ->
                                        ANYWHERE.areNeeded(each.sends())
                                                || ANYWHERE.areNeededFor(each.assignments()));
    }

    /** Whether a division by zero has to be looked out for. */
    static boolean isNeeded(Expression.Binary binary) {
        return Presence.mayDivideByZero(binary);
    }

    /** Whether a number that is beyond 64 bits may be made a Long. */
    static boolean isNeeded(Expression.Cast cast) {
        return cast.type() instanceof Type.IntegerType integer
                && integer.width() == Type.Width.LONG
                && cast.operand().type() instanceof Type.RealType
                && !isLong(cast.operand());
    }

    private static boolean isLong(Expression e) {
        return e instanceof Expression.Constant constant
                && constant.value() instanceof Value.RealValue number
                && Math.abs(number.value()) < -(double) Long.MIN_VALUE;
    }

    /** Whether a value may leave the range of what it is for. */
    boolean isNeeded(Expression value, Type wanted) {
        return !Interval.fits(value, wanted, this::read);
    }

    private Interval read(Expression.VariableRead read) {
        Interval type = Interval.ofType(read);
        Interval narrower = known.get(read.variable().name());
        return narrower == null ? type : type.within(narrower);
    }
}
