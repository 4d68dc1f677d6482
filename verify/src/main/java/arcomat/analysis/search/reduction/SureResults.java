package arcomat.analysis.search.reduction;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.semantics.expression.Interval;

/** Expressions that go well wherever they are computed. Errs on the side of no. */
public final class SureResults {
    private static final Interval ZERO = Interval.of(0, 0);

    private SureResults() {}

    /** Whether a value can always be computed, and always is one of a type. */
    public static boolean isSure(Expression value, Type target) {
        return !mayDivideByZero(value) && isWithin(value, target);
    }

    private static boolean isWithin(Expression value, Type target) {
        if (!(target instanceof Type.IntegerType integer) || !integer.ranged()) {
            return true;
        }
        return readsKnownTypes(value)
                && Interval.of(value).isWithin(Interval.of(integer.low(), integer.high()));
    }

    /** Nobody has compared an argument, or an attribute, with the range of its type. */
    private static boolean readsKnownTypes(Expression e) {
        return !(e instanceof Expression.ParameterRead)
                && !(e instanceof Expression.AttributeRead)
                && e.operands().stream().allMatch(SureResults::readsKnownTypes);
    }

    /** Only integers have no quotient by zero. */
    static boolean mayDivideByZero(Expression e) {
        return e.contains(
                part ->
                        part instanceof Expression.Binary binary
                                && binary.operator().divides()
                                && Interval.isInteger(binary.type())
                                && mayBeZero(binary.right()));
    }

    private static boolean mayBeZero(Expression divisor) {
        return !readsKnownTypes(divisor) || ZERO.isWithin(Interval.of(divisor));
    }

    /** Whether it can always be told if a transition is enabled. */
    public static boolean isSureCondition(Automaton.Transition transition) {
        return transition.guard().stream().noneMatch(SureResults::mayDivideByZero)
                && transition.matches().stream()
                        .flatMap(match -> match.pattern().values().stream())
                        .noneMatch(SureResults::mayDivideByZero);
    }
}
