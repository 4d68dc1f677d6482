package arcomat.analysis.search.letter;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.DataSorts.Sort;
import arcomat.semantics.value.FirstValues;
import arcomat.semantics.value.MessageClasses;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Values of a sort that nobody knows yet, some of each gap between the constants that order matters
 * to; all in one gap where it does not matter. Always the first ones, so that few are met at all.
 *
 * @param gaps in each, fewer than were asked for where there are no more
 */
record FreshValues(List<List<Value>> gaps) {

    /**
     * @param held values of the sort that are known beside its constants
     * @param count how many are wanted in each gap
     */
    static FreshValues of(Sort sort, List<Value> held, int count) {
        Set<Value> known = new HashSet<>(held);
        known.addAll(sort.constants());
        if (!sort.ordered()) {
            List<Value> first = FirstValues.of(sort.type(), known.size() + count);
            return new FreshValues(List.of(unknown(first, known, count)));
        }
        List<List<Value>> gaps = new ArrayList<>();
        for (OpenInterval gap : OpenInterval.between(sort.type(), sort.constants())) {
            gaps.add(unknown(gap.first(known.size() + count), known, count));
        }
        return new FreshValues(gaps);
    }

    private static List<Value> unknown(List<Value> some, Set<Value> known, int count) {
        return some.stream().filter(value -> !known.contains(value)).limit(count).toList();
    }

    /** Those that fit into a type. */
    List<Value> in(Type type) {
        return gaps.stream()
                .flatMap(List::stream)
                .filter(value -> MessageClasses.isIn(type, value))
                .toList();
    }

    /** Whether of each gap the first is met first, then the second, and so on. */
    boolean areInOrder(List<Value> met) {
        for (List<Value> gap : gaps) {
            int next = 0;
            for (Value value : met) {
                int position = gap.indexOf(value);
                if (position > next) {
                    return false;
                }
                next += position == next ? 1 : 0;
            }
        }
        return true;
    }
}
