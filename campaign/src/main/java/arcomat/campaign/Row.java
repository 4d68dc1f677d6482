package arcomat.campaign;

import arcomat.campaign.coverage.ReachedItems;

import java.util.Arrays;
import java.util.List;

/**
 * What came of one run.
 *
 * @param remark why there are no answers; empty where the run was made
 * @param answers in the order of {@link Campaign#columns}, none where the run was not made; an
 *     event is 1 or 0, and what a run has no number for is not a number
 * @param reached what it has covered of the automata of its programs
 */
public record Row(
        Trial trial, Ending ending, String remark, List<Double> answers, ReachedItems reached) {
    public Row {
        answers = List.copyOf(answers);
    }

    /** How a run can end. */
    public enum Ending {
        /** It was made, whatever happened in it. */
        MADE("made"),
        /** The world is none with these values. */
        IMPOSSIBLE("impossible"),
        /** It took too long by the PC's clock: nobody knows what would have happened. */
        GIVEN_UP("given up");

        private final String word;

        Ending(String word) {
            this.word = word;
        }

        /** As the table says it. */
        public String word() {
            return word;
        }

        static Ending of(String cell) {
            return Arrays.stream(values())
                    .filter(each -> cell.startsWith(each.word))
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException(cell));
        }
    }

    /** A run of whose programs nobody knows what they cover. */
    public static Row made(Trial trial, List<Double> answers) {
        return made(trial, answers, ReachedItems.UNKNOWN);
    }

    public static Row made(Trial trial, List<Double> answers, ReachedItems reached) {
        return new Row(trial, Ending.MADE, "", answers, reached);
    }

    /**
     * @param ending another one than {@link Ending#MADE}
     */
    public static Row withoutAnswers(Trial trial, Ending ending, String why) {
        // One line of the table is one line of its file.
        return new Row(trial, ending, why.replaceAll("\\s+", " "), List.of(), ReachedItems.UNKNOWN);
    }

    public boolean wasMade() {
        return ending == Ending.MADE;
    }

    public double answer(int column) {
        return answers.get(column);
    }

    public boolean happened(int column) {
        return answers.get(column) == 1;
    }

    /** Whether it says something about a column: else nobody knows. */
    public boolean answers(int column) {
        return wasMade() && !Double.isNaN(answers.get(column));
    }
}
