package arcomat.generate;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What is known where conditions do not hold, found by what it begins with: there may be many. */
final class Excluded {
    private final Map<Formula, List<Known>> byFirst = new HashMap<>();
    private int count;

    /**
     * All that one condition says by not holding.
     *
     * @param number in the order of the conditions
     */
    private record Known(int number, List<Formula> conjuncts) {}

    /** Adds that the conjunction of all these holds. */
    void add(List<Formula> conjuncts) {
        if (!conjuncts.isEmpty()) {
            byFirst.computeIfAbsent(conjuncts.get(0), first -> new ArrayList<>())
                    .add(new Known(count++, conjuncts));
        }
    }

    /** What is left of a conjunction that is known in part. */
    List<Formula> without(List<Formula> conjuncts) {
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
