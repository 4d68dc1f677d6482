package arcomat.generate;

import arcomat.model.Port;
import arcomat.model.Type;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Keeps conditions as short as a person would write them. Enum ports are codes where 0 is no
 * message: that a code equals a constant says already that there is a message.
 */
final class Simplification {
    private final Predicate<Port> mayBeAbsent;

    Simplification(Predicate<Port> mayBeAbsent) {
        this.mayBeAbsent = mayBeAbsent;
    }

    /** Conjunction; operands may rely on those before them. */
    Formula and(List<Formula> operands) {
        Set<Formula> kept = new LinkedHashSet<>();
        Set<String> present = new HashSet<>();
        for (Formula operand : flat(operands, true)) {
            Formula reduced = under(operand, present);
            if (reduced.equals(Formula.FALSE)) {
                return Formula.FALSE;
            }
            for (Formula conjunct : reduced.conjuncts()) {
                if (kept.add(conjunct)) {
                    addPresent(conjunct, present);
                }
            }
        }
        List<Formula> needed = needed(kept);
        return needed.isEmpty()
                ? Formula.TRUE
                : needed.size() == 1 ? needed.get(0) : new Formula.And(needed);
    }

    Formula or(List<Formula> operands) {
        Set<Formula> kept = new LinkedHashSet<>();
        for (Formula operand : flat(operands, false)) {
            if (operand.equals(Formula.TRUE)) {
                return Formula.TRUE;
            }
            if (!operand.equals(Formula.FALSE)) {
                kept.add(operand);
            }
        }
        return kept.isEmpty()
                ? Formula.FALSE
                : kept.size() == 1 ? kept.iterator().next() : new Formula.Or(List.copyOf(kept));
    }

    Formula not(Formula f) {
        if (f instanceof Formula.Truth truth) {
            return new Formula.Truth(!truth.value());
        }
        if (f instanceof Formula.Carries carries) {
            return new Formula.Carries(carries.port(), !carries.something());
        }
        if (f instanceof Formula.Is is) {
            return negated(is);
        }
        if (f instanceof Formula.Not not) {
            return not.operand();
        }
        if (f instanceof Formula.Or or && or.operands().stream().allMatch(this::isLiteral)) {
            return and(or.operands().stream().map(this::not).toList());
        }
        return new Formula.Not(f);
    }

    private static Formula negated(Formula.Is is) {
        if (is.constant().isPresent()
                && is.constant().get() instanceof arcomat.model.Value.BooleanValue truth) {
            return new Formula.Is(
                    is.port(),
                    true,
                    java.util.Optional.of(new arcomat.model.Value.BooleanValue(!truth.value())),
                    is.negated(),
                    is.text());
        }
        return new Formula.Is(is.port(), !is.equal(), is.constant(), is.negated(), is.text());
    }

    private boolean isLiteral(Formula f) {
        return f instanceof Formula.Carries || f instanceof Formula.Is;
    }

    private static List<Formula> flat(List<Formula> operands, boolean and) {
        List<Formula> flat = new ArrayList<>();
        for (Formula operand : operands) {
            if (and && operand instanceof Formula.And inner) {
                flat.addAll(inner.operands());
            } else if (!and && operand instanceof Formula.Or inner) {
                flat.addAll(inner.operands());
            } else if (!(operand instanceof Formula.Truth truth && truth.value() == and)) {
                flat.add(operand);
            }
        }
        return flat;
    }

    /** The formula where some ports are known to carry a message. */
    private Formula under(Formula f, Set<String> present) {
        if (f instanceof Formula.Carries carries) {
            boolean certain =
                    !mayBeAbsent.test(carries.port()) || present.contains(carries.port().name());
            return certain ? new Formula.Truth(carries.something()) : f;
        }
        if (f instanceof Formula.Not not) {
            return not(under(not.operand(), present));
        }
        if (f instanceof Formula.And and) {
            Set<String> known = new HashSet<>(present);
            List<Formula> reduced = new ArrayList<>();
            for (Formula operand : and.operands()) {
                reduced.add(under(operand, known));
                addPresent(operand, known);
            }
            return and(reduced);
        }
        if (f instanceof Formula.Or or) {
            return or(or.operands().stream().map(o -> under(o, present)).toList());
        }
        return f;
    }

    /** Adds the ports that carry a message wherever the formula holds. */
    private static void addPresent(Formula f, Set<String> present) {
        if (f instanceof Formula.Carries carries && carries.something()) {
            present.add(carries.port().name());
        } else if (f instanceof Formula.Is is && is.equal()) {
            present.add(is.port().name());
        } else if (f instanceof Formula.And and) {
            and.operands().forEach(o -> addPresent(o, present));
        } else if (f instanceof Formula.Or or) {
            Set<String> everywhere = null;
            for (Formula operand : or.operands()) {
                Set<String> here = new HashSet<>();
                addPresent(operand, here);
                if (everywhere == null) {
                    everywhere = here;
                } else {
                    everywhere.retainAll(here);
                }
            }
            present.addAll(everywhere == null ? Set.of() : everywhere);
        }
    }

    /** Those of the conjuncts that say more than others do. */
    private static List<Formula> needed(Collection<Formula> conjuncts) {
        Map<String, Integer> presences = new HashMap<>();
        List<Formula> strong = new ArrayList<>();
        for (Formula each : conjuncts) {
            Set<String> present = new HashSet<>();
            addPresent(each, present);
            present.forEach(port -> presences.merge(port, 1, Integer::sum));
            if (!(each instanceof Formula.Is is) || is.equal()) {
                strong.add(each);
            }
        }
        return conjuncts.stream().filter(each -> !isImplied(each, presences, strong)).toList();
    }

    /**
     * Whether a conjunct says no more than another one does.
     *
     * @param presences how many conjuncts say that a port carries a message
     * @param strong conjuncts that are not only about another message than one
     */
    private static boolean isImplied(
            Formula f, Map<String, Integer> presences, List<Formula> strong) {
        if (f instanceof Formula.Carries carries
                && carries.something()
                && carries.port().type() instanceof Type.EnumType) {
            return presences.get(carries.port().name()) > 1;
        }
        return f instanceof Formula.Is is
                && !is.equal()
                && strong.stream().anyMatch(each -> Exclusion.contradict(each, equalTo(is)));
    }

    private static Formula equalTo(Formula.Is different) {
        return new Formula.Is(
                different.port(),
                true,
                different.constant(),
                different.negated(),
                different.text());
    }

    /**
     * The formula where earlier ones are known not to hold: what only says so again is dropped, as
     * in the rows of an I/O table.
     */
    Formula after(Excluded earlier, Formula f) {
        return and(earlier.without(f.conjuncts()));
    }

    /**
     * The same where all cases can be looked at: what follows from the earlier ones and from the
     * rest is dropped as well.
     */
    Formula inOpenCases(List<Formula> earlier, Formula f) {
        return Cases.of(mayBeAbsent, f, earlier)
                .map(cases -> and(cases.needed(f.conjuncts())))
                .orElse(f);
    }
}
