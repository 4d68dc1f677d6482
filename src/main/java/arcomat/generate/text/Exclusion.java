package arcomat.generate.text;

import arcomat.model.Port;
import arcomat.model.Value;

import java.util.List;
import java.util.function.Predicate;

/**
 * Whether two conditions can hold together, as far as their form shows it. Where it is shown that
 * they cannot, there is nothing to choose between their transitions.
 */
public final class Exclusion {
    /**
     * By the form of one that is no row: which others contradict it, that deny it as a whole aside.
     */
    private static final Formula.Cases<Predicate<Formula>> CONTRADICTING =
            new Formula.Cases<>(
                    carries -> other -> presencesContradict(carries, other),
                    one -> other -> isContradicts(one, other),
                    one -> other -> other instanceof Formula.Test two && boundsContradict(one, two),
                    not -> other -> not.operand().equals(other),
                    row -> other -> false,
                    judged -> other -> false);

    private Exclusion() {}

    public static boolean contradict(Formula a, Formula b) {
        if (a instanceof Formula.Row row && !row.all()) {
            return row.operands().stream().allMatch(o -> contradict(o, b));
        }
        if (b instanceof Formula.Row row && !row.all()) {
            return row.operands().stream().allMatch(o -> contradict(a, o));
        }
        if (a instanceof Formula.Row || b instanceof Formula.Row) {
            return deniesAsWhole(a, b)
                    || deniesAsWhole(b, a)
                    || a.conjuncts().stream().anyMatch(x -> anyContradicts(x, b.conjuncts()));
        }
        return contradicting(a).test(b);
    }

    private static boolean anyContradicts(Formula conjunct, List<Formula> others) {
        Predicate<Formula> contradicting = contradicting(conjunct);
        for (Formula other : others) {
            boolean row = conjunct instanceof Formula.Row || other instanceof Formula.Row;
            if (row ? contradict(conjunct, other) : contradicting.test(other)) {
                return true;
            }
        }
        return false;
    }

    /** One of them says that the other does not hold: rows of an I/O table do. */
    private static boolean deniesAsWhole(Formula a, Formula b) {
        return b.conjuncts().contains(new Formula.Not(a));
    }

    /** Which formulas that are no rows contradict one that is none. */
    private static Predicate<Formula> contradicting(Formula one) {
        Predicate<Formula> byForm = one.match(CONTRADICTING);
        return other ->
                byForm.test(other) || other instanceof Formula.Not not && not.operand().equals(one);
    }

    private static boolean presencesContradict(Formula.Carries one, Formula other) {
        return one.something()
                ? other.equals(new Formula.Carries(one.port(), false))
                : needsMessage(other, one.port());
    }

    private static boolean isContradicts(Formula.Is one, Formula other) {
        return other instanceof Formula.Is two
                ? valuesContradict(one, two)
                : one.equal() && other.equals(new Formula.Carries(one.port(), false));
    }

    private static boolean needsMessage(Formula f, Port port) {
        return f.equals(new Formula.Carries(port, true))
                || f instanceof Formula.Is is && is.equal() && is.port().equals(port);
    }

    private static boolean boundsContradict(Formula.Test one, Formula.Test two) {
        return one.bounds().isPresent()
                && two.bounds().isPresent()
                && one.bounds().get().excludes(two.bounds().get());
    }

    private static boolean valuesContradict(Formula.Is one, Formula.Is two) {
        if (!one.port().equals(two.port())) {
            return false;
        }
        if (one.equal() && two.equal()) {
            return one.constant().isPresent()
                    && two.constant().isPresent()
                    && differ(one.constant().get(), two.constant().get());
        }
        return one.text().equals(two.negated());
    }

    /** No message equals both: 0.0 and -0.0 are one number. */
    private static boolean differ(Value one, Value two) {
        return one instanceof Value.RealValue left && two instanceof Value.RealValue right
                ? left.value() != right.value()
                : !one.equals(two);
    }
}
