package arcomat.analysis.search.product;

import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.step.Steps;

import java.util.Arrays;

/** Steps by configuration and alphabet; most configurations meet very few alphabets. */
final class StepTable {
    private record Row(Alphabet alphabet, Steps[] steps, Row next) {}

    private Row[] first = new Row[64];

    /** Null where there are none yet. */
    Steps[] find(int configuration, Alphabet alphabet) {
        Row row = configuration < first.length ? first[configuration] : null;
        while (row != null && row.alphabet != alphabet) {
            row = row.next;
        }
        return row == null ? null : row.steps;
    }

    void add(int configuration, Alphabet alphabet, Steps[] steps) {
        if (configuration >= first.length) {
            first = Arrays.copyOf(first, Math.max(configuration + 1, 2 * first.length));
        }
        first[configuration] = new Row(alphabet, steps, first[configuration]);
    }
}
