package arcomat.guest;

import arcomat.source.Span;

import java.util.List;

/**
 * A question about one automaton, of which all is known that its runs may come to: what {@code
 * analyze}, the editor, and pictures with findings ask besides the tool's own questions.
 */
public interface AutomatonAnalysis {
    /** The codes of what it may find, as those of a guest's laws, each with a page. */
    List<String> codes();

    /**
     * Says what the author of an automaton may have overlooked. It keeps nothing for the next one,
     * and answers from what it is given alone: it may be asked anywhere, and several times.
     *
     * @param findings take what it finds
     */
    void examine(AutomatonRuns runs, Findings findings);

    /** Takes what an analysis finds. */
    interface Findings {
        /**
         * Something that is there whatever happens.
         *
         * @param code one of {@link AutomatonAnalysis#codes}
         * @param place in the text of the automaton; what the elements of the model say of theirs
         * @param message as those of the tool: it names the thing, says what to do, and begins with
         *     a small letter; a format for the values, if there are some
         */
        void report(String code, Span place, String message, Object... values);

        /**
         * Something that is seen where a run has come to; a shortest run to there is shown with it.
         *
         * @param seen one of {@link AutomatonRuns#configurations}
         */
        void reportAt(
                AutomatonRuns.Reached seen,
                String code,
                Span place,
                String message,
                Object... values);
    }
}
