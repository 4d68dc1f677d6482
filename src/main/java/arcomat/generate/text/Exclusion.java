package arcomat.generate.text;

import arcomat.model.Port;
import arcomat.model.Value;

import java.util.List;

/**
 * Whether two conditions can hold together, as far as their form shows it. Where it is shown that
 * they cannot, there is nothing to choose between their transitions.
 */
public final class Exclusion {
    private Exclusion() {}

    public static boolean contradict(Formula a, Formula b) {
        if (a instanceof Formula.Row row && !row.all()) {
            return row.operands().stream().allMatch(o -> contradict(o, b));
        }
        if (b instanceof Formula.Row row && !row.all()) {
            return row.operands().stream().allMatch(o -> contradict(a, o));
        }
        if (a instanceof Formula.Row || b instanceof Formula.Row) {
            return excludesAsWhole(a, b)
                    || excludesAsWhole(b, a)
                    || a.conjuncts().stream().anyMatch(x -> anyContradicts(x, b.conjuncts()));
        }
        return contradicts(a, b) || contradicts(b, a);
    }

    private static boolean anyContradicts(Formula literal, List<Formula> others) {
        return others.stream().anyMatch(other -> contradict(literal, other));
    }

    /** One of them says that the other does not hold: rows of an I/O table do. */
    private static boolean excludesAsWhole(Formula a, Formula b) {
        return b.conjuncts().contains(new Formula.Not(a));
    }

    /** Whether a formula that is no row contradicts another one that is none, by what it says. */
    private static boolean contradicts(Formula a, Formula b) {
        return a.match(
                new Formula.Cases<>(
                        carries -> !carries.something() && needsMessage(b, carries.port()),
                        one -> b instanceof Formula.Is two && valuesContradict(one, two),
                        one -> b instanceof Formula.Test two && boundsContradict(one, two),
                        not -> not.operand().equals(b),
                        row -> false));
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
