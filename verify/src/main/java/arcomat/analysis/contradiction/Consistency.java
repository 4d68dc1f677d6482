package arcomat.analysis.contradiction;

import arcomat.analysis.game.CounterStrategy.Turn;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Whether the requirements on a component can be kept together.
 *
 * @param answer holds where there is no contradiction
 * @param reason of an unknown, what stood in the way; else empty
 * @param contradictions one, or all minimal ones; only of a failure
 * @param controller keeps all requirements; only where there is no contradiction
 * @param notes what a reader should know besides
 * @param explored positions of the games that were played
 */
public record Consistency(
        Answer answer,
        String reason,
        List<Contradiction> contradictions,
        Optional<Component> controller,
        List<String> notes,
        long explored) {
    public Consistency {
        contradictions = List.copyOf(contradictions);
        notes = List.copyOf(notes);
    }

    /** With one more note. */
    Consistency with(String note) {
        List<String> more = Stream.concat(notes.stream(), Stream.of(note)).toList();
        return new Consistency(answer, reason, contradictions, controller, more, explored);
    }

    /**
     * Requirements that no system can satisfy together, and how inputs bring that to light.
     *
     * @param requirements as few as possible, in text order
     * @param minimal whether it is certain that none of them can be left out
     * @param word a shortest word of inputs after which no output complies, whatever was sent
     *     before; empty where the inputs have to depend on the outputs
     * @param decided whether it is certain that there is no such word if none was found
     * @param steps the first one is the beginning, the others are referred to by number
     */
    public record Contradiction(
            List<Automaton> requirements,
            boolean minimal,
            Optional<List<Letter>> word,
            boolean decided,
            List<Step> steps) {
        public Contradiction {
            requirements = List.copyOf(requirements);
            word = word.map(List::copyOf);
            steps = List.copyOf(steps);
        }

        /**
         * An input with what may be answered.
         *
         * @param answers outputs that break no requirement at once, each with the step that
         *     follows; other outputs do, or leave the requirements no more room than one of these
         * @param demands what each requirement asks for, where nothing complies
         */
        public record Step(Letter input, List<Turn.Answer> answers, List<Sentence> demands) {
            public Step {
                answers = List.copyOf(answers);
                demands = List.copyOf(demands);
            }
        }
    }
}
