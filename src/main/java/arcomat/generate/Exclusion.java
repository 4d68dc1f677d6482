package arcomat.generate;

import arcomat.model.Value;

import java.util.List;

/**
 * Whether two conditions can hold together, as far as their form shows it. Where it is shown that
 * they cannot, there is nothing to choose between their transitions.
 */
final class Exclusion {
    private Exclusion() {}

    static boolean contradict(Formula a, Formula b) {
        if (a instanceof Formula.Or or) {
            return or.operands().stream().allMatch(o -> contradict(o, b));
        }
        if (b instanceof Formula.Or or) {
            return or.operands().stream().allMatch(o -> contradict(a, o));
        }
        if (a instanceof Formula.And || b instanceof Formula.And) {
            return excludesAsWhole(a, b)
                    || excludesAsWhole(b, a)
                    || a.conjuncts().stream().anyMatch(x -> anyContradicts(x, b.conjuncts()));
        }
        return literalsContradict(a, b) || literalsContradict(b, a);
    }

    private static boolean anyContradicts(Formula literal, List<Formula> others) {
        return others.stream().anyMatch(other -> contradict(literal, other));
    }

    /** One of them says that the other does not hold: rows of an I/O table do. */
    private static boolean excludesAsWhole(Formula a, Formula b) {
        return b.conjuncts().contains(new Formula.Not(a));
    }

    private static boolean literalsContradict(Formula a, Formula b) {
        if (a instanceof Formula.Truth truth) {
            return !truth.value();
        }
        if (a instanceof Formula.Not not) {
            return not.operand().equals(b);
        }
        if (a instanceof Formula.Carries carries && !carries.something()) {
            return b instanceof Formula.Carries other
                            && other.something()
                            && other.port().equals(carries.port())
                    || b instanceof Formula.Is is && is.equal() && is.port().equals(carries.port());
        }
        if (a instanceof Formula.Is one
                && b instanceof Formula.Is two
                && one.port().equals(two.port())) {
            return valuesContradict(one, two);
        }
        return a instanceof Formula.Test one
                && b instanceof Formula.Test two
                && one.bounds().isPresent()
                && two.bounds().isPresent()
                && one.bounds().get().excludes(two.bounds().get());
    }

    /** No message equals both: 0.0 and -0.0 are one number. */
    private static boolean differ(Value one, Value two) {
        return one instanceof Value.RealValue left && two instanceof Value.RealValue right
                ? left.value() != right.value()
                : !one.equals(two);
    }

    private static boolean valuesContradict(Formula.Is one, Formula.Is two) {
        if (one.equal() && two.equal()) {
            return one.constant().isPresent()
                    && two.constant().isPresent()
                    && differ(one.constant().get(), two.constant().get());
        }
        return one.text().equals(two.negated());
    }
}
