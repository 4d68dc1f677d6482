package arcomat.report.verdict;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.game.CounterStrategy.Turn;
import arcomat.analysis.refinement.Verdict;
import arcomat.model.Letter;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Contradictions, or the controller that shows that there are none, for programs. */
public record ConsistencyJson(
        String verdict,
        String reason,
        List<Conflict> contradictions,
        Optional<String> controller,
        Optional<String> requirements,
        Optional<String> file,
        List<String> notes,
        Explored explored) {

    /** Requirements that contradict each other, by name. */
    record Conflict(
            List<String> requirements,
            boolean minimal,
            Optional<List<Input>> word,
            List<Step> steps) {
        static Conflict of(Contradiction contradiction) {
            return new Conflict(
                    ConsistencyText.names(contradiction),
                    contradiction.minimal(),
                    contradiction.word().map(word -> word.stream().map(Input::of).toList()),
                    contradiction.steps().stream().map(Step::of).toList());
        }
    }

    record Input(Map<String, Object> in) {
        static Input of(Letter letter) {
            return new Input(VerdictJson.inputs(letter));
        }
    }

    record Step(Map<String, Object> in, List<Answer> answers, List<VerdictJson.Reason> demands) {
        static Step of(Contradiction.Step step) {
            return new Step(
                    VerdictJson.inputs(step.input()),
                    step.answers().stream().map(Answer::of).toList(),
                    VerdictJson.Reason.all(step.demands()));
        }
    }

    record Answer(Map<String, Object> out, int then) {
        static Answer of(Turn.Answer answer) {
            return new Answer(VerdictJson.outputs(answer.outputs()), answer.next());
        }
    }

    record Explored(long positions) {}

    /**
     * @param controller its text
     * @param requirements the text of what it refines, where that is no component yet
     * @param file where that was written
     */
    public static String render(
            Consistency found,
            Optional<String> controller,
            Optional<String> requirements,
            Optional<String> file) {
        boolean fails = found.answer() == Verdict.Answer.FAILS;
        return Json.text(
                new ConsistencyJson(
                        Printable.word(found.answer()),
                        fails ? "contradiction" : found.reason(),
                        found.contradictions().stream().map(Conflict::of).toList(),
                        controller,
                        requirements,
                        file,
                        found.notes(),
                        new Explored(found.explored())));
    }
}
