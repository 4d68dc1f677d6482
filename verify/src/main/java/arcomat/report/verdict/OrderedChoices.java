package arcomat.report.verdict;

import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Question;

import java.util.ArrayList;
import java.util.List;

/**
 * Goes through all choices of runs over the same input, in order: the first run takes the first
 * alternative everywhere, the next one differs from it as late as it can.
 */
final class OrderedChoices implements Choice {
    private final List<Integer> picks = new ArrayList<>();
    private final List<Integer> counts = new ArrayList<>();
    private int asked;

    /** A run begins; it takes the same alternatives as the last one, as far as they are fixed. */
    void begin() {
        asked = 0;
    }

    @Override
    public int pick(Question question) {
        if (asked == picks.size()) {
            picks.add(0);
            counts.add(question.count());
        }
        return picks.get(asked++);
    }

    /** Turns to the next alternatives behind a run that ended; false where there are none. */
    boolean advance() {
        while (!picks.isEmpty()) {
            int last = picks.size() - 1;
            if (picks.get(last) + 1 < counts.get(last)) {
                picks.set(last, picks.get(last) + 1);
                return true;
            }
            picks.remove(last);
            counts.remove(last);
        }
        return false;
    }
}
