package arcomat.generate.text;

import arcomat.model.Port;
import arcomat.model.Type;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.IntStream;

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
        return and(Set.of(), operands);
    }

    /** Each operand is reduced once: whoever nests them does not pay for each level again. */
    private Formula and(Set<String> before, List<Formula> operands) {
        Set<Formula> kept = new LinkedHashSet<>();
        Set<String> present = new HashSet<>(before);
        for (Formula operand : flat(operands, true)) {
            Formula reduced = under(present, operand);
            if (reduced.equals(Formula.FALSE)) {
                return decided(List.copyOf(kept), Formula.FALSE);
            }
            for (Formula conjunct : reduced.conjuncts()) {
                if (kept.add(conjunct)) {
                    present.addAll(present(conjunct));
                }
            }
        }
        return Formula.Row.of(true, needed(List.copyOf(kept)));
    }

    public Formula or(List<Formula> operands) {
        List<Formula> flat = flat(operands, false).stream().distinct().toList();
        int certain = flat.indexOf(Formula.TRUE);
        return certain < 0
                ? Formula.Row.of(false, flat)
                : decided(flat.subList(0, certain), Formula.TRUE);
    }

    /**
     * A row that an operand decides: what may go wrong before it still does, and where depends on
     * what stands before that.
     *
     * @param decides false in a conjunction, true in a disjunction
     */
    private static Formula decided(List<Formula> before, Formula decides) {
        int last = before.size() - 1;
        while (last >= 0 && !before.get(last).mayFail()) {
            last--;
        }
        List<Formula> row = new ArrayList<>(before.subList(0, last + 1));
        row.add(decides);
        return Formula.Row.of(decides.equals(Formula.FALSE), row);
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
                        this::negation,
                        Formula.Not::new));
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
                        carries ->
                                isCertain(carries.port(), present)
                                        ? Formula.of(carries.something())
                                        : carries,
                        is -> is,
                        test -> test,
                        not -> not(under(present, not.operand())),
                        row -> under(present, row),
                        judged -> judged));
    }

    /** A row has been reduced when it was made: it stays as it is where nothing new is known. */
    private Formula under(Set<String> present, Formula.Row row) {
        if (!asksForKnown(present, row)) {
            return row;
        }
        return row.all()
                ? and(present, row.operands())
                : or(row.operands().stream().map(each -> under(present, each)).toList());
    }

    private boolean asksForKnown(Set<String> present, Formula f) {
        return f.match(
                new Formula.Cases<>(
                        carries -> isCertain(carries.port(), present),
                        is -> false,
                        test -> false,
                        not -> asksForKnown(present, not.operand()),
                        row -> row.operands().stream().anyMatch(o -> asksForKnown(present, o)),
                        judged -> false));
    }

    private boolean isCertain(Port port, Set<String> present) {
        return !mayBeAbsent.test(port) || present.contains(port.name());
    }

    /** The ports that carry a message wherever the formula holds. */
    private static Set<String> present(Formula f) {
        return f.match(
                new Formula.Cases<>(
                        carries -> carries.something() ? Set.of(carries.port().name()) : Set.of(),
                        is -> is.equal() ? Set.of(is.port().name()) : Set.of(),
                        test -> Set.of(),
                        not -> Set.of(),
                        Simplification::presentIn,
                        judged -> Set.of()));
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
    private static List<Formula> needed(List<Formula> conjuncts) {
        return conjuncts.stream().anyMatch(Simplification::mayBeImplied)
                ? new Conjuncts(conjuncts).needed()
                : conjuncts;
    }

    private static boolean mayBeImplied(Formula f) {
        return f instanceof Formula.Carries carries
                ? carries.something() && carries.port().type() instanceof Type.EnumType
                : f instanceof Formula.Is is && !is.equal();
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
     * Conjuncts, of which some say no more than others do. One that says less may be dropped for
     * one that stands behind it only if nothing may go wrong in between: else that is looked at
     * where it has not been before.
     */
    private static final class Conjuncts {
        private final List<Formula> all;

        /** By position, how many that may go wrong stand before a conjunct, with it. */
        private final int[] mayFail;

        /** Which conjuncts say that a port carries a message, in their order. */
        private final Map<String, List<Integer>> presences = new HashMap<>();

        /** Those that may exclude that a port carries a certain message. */
        private final List<Integer> strong = new ArrayList<>();

        Conjuncts(List<Formula> all) {
            this.all = all;
            mayFail = new int[all.size()];
            for (int i = 0; i < mayFail.length; i++) {
                int position = i;
                Formula each = all.get(i);
                mayFail[i] = (i == 0 ? 0 : mayFail[i - 1]) + (each.mayFail() ? 1 : 0);
                present(each)
                        .forEach(
                                port ->
                                        presences
                                                .computeIfAbsent(port, key -> new ArrayList<>())
                                                .add(position));
                if (mayExcludeMessage(each)) {
                    strong.add(i);
                }
            }
        }

        /** Neither does another test, nor that there is another message than one. */
        private static boolean mayExcludeMessage(Formula f) {
            return !(f instanceof Formula.Test) && (!(f instanceof Formula.Is is) || is.equal());
        }

        List<Formula> needed() {
            return IntStream.range(0, all.size())
                    .filter(i -> !mayBeImplied(all.get(i)) || !isImplied(i))
                    .mapToObj(all::get)
                    .toList();
        }

        private boolean isImplied(int position) {
            if (all.get(position) instanceof Formula.Carries carries) {
                return Objects.requireNonNull(presences.get(carries.port().name())).stream()
                        .anyMatch(other -> other != position && isAsSafe(other, position));
            }
            Formula.Is opposite = ((Formula.Is) all.get(position)).negation();
            return strong.stream()
                    .filter(other -> isAsSafe(other, position))
                    .anyMatch(other -> Exclusion.contradict(all.get(other), opposite));
        }

        /** Whether nothing more may go wrong before one is known to hold than before another. */
        private boolean isAsSafe(int one, int another) {
            return mayFail[one] <= mayFail[another];
        }
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
