package arcomat.generate.text;

import arcomat.model.Port;
import arcomat.model.Type;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Keeps conditions as short as a person would write them. Enum ports are codes where 0 is no
 * message: that a code equals a constant says already that there is a message.
 */
public final class Simplification {
    private final Predicate<Port> mayBeAbsent;

    public Simplification(Predicate<Port> mayBeAbsent) {
        this.mayBeAbsent = mayBeAbsent;
    }

    /** Conjunction; operands may rely on those before them. */
    public Formula and(List<Formula> operands) {
        Set<Formula> kept = new LinkedHashSet<>();
        Set<String> present = new HashSet<>();
        for (Formula operand : flat(operands, true)) {
            Formula reduced = under(present, operand);
            if (reduced.equals(Formula.FALSE)) {
                return Formula.FALSE;
            }
            for (Formula conjunct : reduced.conjuncts()) {
                if (kept.add(conjunct)) {
                    present.addAll(present(conjunct));
                }
            }
        }
        return Formula.Row.of(true, needed(kept));
    }

    public Formula or(List<Formula> operands) {
        List<Formula> flat = flat(operands, false);
        return flat.contains(Formula.TRUE)
                ? Formula.TRUE
                : Formula.Row.of(false, flat.stream().distinct().toList());
    }

    private static List<Formula> flat(List<Formula> operands, boolean all) {
        List<Formula> flat = new ArrayList<>();
        for (Formula operand : operands) {
            if (operand instanceof Formula.Row row && row.all() == all) {
                flat.addAll(row.operands());
            } else {
                flat.add(operand);
            }
        }
        return flat;
    }

    public Formula not(Formula f) {
        return f.match(
                new Formula.Cases<>(
                        carries -> new Formula.Carries(carries.port(), !carries.something()),
                        Formula.Is::negation,
                        Formula.Not::new,
                        Formula.Not::operand,
                        this::negation));
    }

    /** Alternatives that are only about messages are all excluded, others as a whole. */
    private Formula negation(Formula.Row row) {
        if (!row.all() && row.operands().stream().allMatch(Simplification::isLiteral)) {
            return and(row.operands().stream().map(this::not).toList());
        }
        return row.equals(Formula.TRUE) ? Formula.FALSE : new Formula.Not(row);
    }

    private static boolean isLiteral(Formula f) {
        return f instanceof Formula.Carries || f instanceof Formula.Is;
    }

    /** The formula where some ports are known to carry a message. */
    private Formula under(Set<String> present, Formula f) {
        return f.match(
                new Formula.Cases<>(
                        carries -> {
                            Port port = carries.port();
                            boolean certain =
                                    !mayBeAbsent.test(port) || present.contains(port.name());
                            return certain ? Formula.of(carries.something()) : carries;
                        },
                        is -> is,
                        test -> test,
                        not -> not(under(present, not.operand())),
                        row -> under(present, row)));
    }

    private Formula under(Set<String> present, Formula.Row row) {
        if (!row.all()) {
            return or(row.operands().stream().map(each -> under(present, each)).toList());
        }
        Set<String> known = new HashSet<>(present);
        List<Formula> reduced = new ArrayList<>();
        for (Formula operand : row.operands()) {
            reduced.add(under(known, operand));
            known.addAll(present(operand));
        }
        return and(reduced);
    }

    /** The ports that carry a message wherever the formula holds. */
    private static Set<String> present(Formula f) {
        return f.match(
                new Formula.Cases<>(
                        carries -> carries.something() ? Set.of(carries.port().name()) : Set.of(),
                        is -> is.equal() ? Set.of(is.port().name()) : Set.of(),
                        test -> Set.of(),
                        not -> Set.of(),
                        Simplification::presentIn));
    }

    private static Set<String> presentIn(Formula.Row row) {
        Set<String> found = new HashSet<>();
        for (Formula operand : row.operands()) {
            if (row.all() || operand == row.operands().get(0)) {
                found.addAll(present(operand));
            } else {
                found.retainAll(present(operand));
            }
        }
        return found;
    }

    /** Those of the conjuncts that say more than others do. */
    private static List<Formula> needed(Collection<Formula> conjuncts) {
        Map<String, Integer> presences = new HashMap<>();
        List<Formula> strong = new ArrayList<>();
        for (Formula each : conjuncts) {
            present(each).forEach(port -> presences.merge(port, 1, Integer::sum));
            if (mayExcludeMessage(each)) {
                strong.add(each);
            }
        }
        return conjuncts.stream().filter(each -> !isImplied(each, presences, strong)).toList();
    }

    /** Neither does another test, nor that there is another message than one. */
    private static boolean mayExcludeMessage(Formula f) {
        return !(f instanceof Formula.Test) && (!(f instanceof Formula.Is is) || is.equal());
    }

    /**
     * Whether a conjunct says no more than another one does.
     *
     * @param presences how many conjuncts say that a port carries a message
     * @param strong conjuncts that may exclude that a port carries a certain message
     */
    private static boolean isImplied(
            Formula f, Map<String, Integer> presences, List<Formula> strong) {
        if (f instanceof Formula.Carries carries
                && carries.something()
                && carries.port().type() instanceof Type.EnumType) {
            return Objects.requireNonNull(presences.get(carries.port().name())) > 1;
        }
        if (!(f instanceof Formula.Is is) || is.equal()) {
            return false;
        }
        Formula.Is opposite = is.negation();
        return strong.stream().anyMatch(each -> Exclusion.contradict(each, opposite));
    }

    /**
     * The formula where earlier ones are known not to hold: what only says so again is dropped, as
     * in the rows of an I/O table.
     */
    public Formula after(Excluded earlier, Formula f) {
        return and(earlier.without(f.conjuncts()));
    }

    /**
     * The same where all cases can be looked at: what follows from the earlier ones and from the
     * rest is dropped as well.
     */
    public Formula inOpenCases(List<Formula> earlier, Formula f) {
        return OpenCases.of(mayBeAbsent, f, earlier)
                .map(cases -> and(cases.needed(f.conjuncts())))
                .orElse(f);
    }

    /**
     * What is known where conditions do not hold, found by what it begins with: there may be many.
     */
    public static final class Excluded {
        private final Map<Formula, List<Known>> byFirst = new HashMap<>();
        private int count;

        /**
         * All that one condition says by not holding.
         *
         * @param number in the order of the conditions
         */
        private record Known(int number, List<Formula> conjuncts) {}

        /** Adds that the conjunction of all these holds. */
        public void add(List<Formula> conjuncts) {
            if (!conjuncts.isEmpty()) {
                byFirst.computeIfAbsent(conjuncts.get(0), first -> new ArrayList<>())
                        .add(new Known(count++, conjuncts));
            }
        }

        /** What is left of a conjunction that is known in part. */
        private List<Formula> without(List<Formula> conjuncts) {
            List<Formula> rest = new ArrayList<>(conjuncts);
            List<Known> candidates =
                    conjuncts.stream()
                            .distinct()
                            .flatMap(each -> byFirst.getOrDefault(each, List.of()).stream())
                            .sorted(Comparator.comparingInt(Known::number))
                            .toList();
            for (Known known : candidates) {
                if (rest.containsAll(known.conjuncts())) {
                    rest.removeAll(known.conjuncts());
                }
            }
            return rest;
        }
    }
}
