package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Moment;
import arcomat.model.Letter;
import arcomat.model.Value;
import arcomat.report.run.MessageJson;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;
import arcomat.semantics.expression.Sent;
import arcomat.source.Span;

import com.fasterxml.jackson.annotation.JsonUnwrapped;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A verdict for programs. */
public record VerdictJson(
        String verdict,
        String reason,
        Optional<Boolean> simulation,
        List<Step> trace,
        List<Reason> explanation,
        List<String> notes,
        Explored explored) {

    /** A question with both sides, and its answer. */
    private record Answer(
            String question, String left, String right, @JsonUnwrapped VerdictJson verdict) {
        static Answer of(Answered each) {
            return new Answer(
                    Printable.word(each.question()),
                    each.left(),
                    each.right(),
                    VerdictJson.of(each.verdict()));
        }
    }

    /** Silent ports are left out; {@code "*"} is an output that is left open. */
    record Step(
            Map<String, Object> in,
            Map<String, Object> out,
            Optional<Boolean> error,
            String left,
            List<String> right) {
        static Step of(Moment moment) {
            return new Step(
                    inputs(moment.input()),
                    outputs(moment.outputs()),
                    Optional.of(true).filter(any -> moment.error()),
                    moment.left(),
                    moment.right());
        }
    }

    /** A sentence, and its place if it has one. */
    record Reason(
            String text, Optional<String> file, Optional<Integer> line, Optional<Integer> column) {
        static Reason of(Sentence sentence) {
            Optional<Span> place = sentence.place();
            return new Reason(
                    sentence.text(),
                    place.map(span -> span.file().path()),
                    place.map(span -> span.startPosition().line()),
                    place.map(span -> span.startPosition().column()));
        }

        static List<Reason> all(List<Sentence> sentences) {
            return sentences.stream().map(Reason::of).toList();
        }
    }

    public static VerdictJson of(Verdict verdict) {
        return new VerdictJson(
                Printable.word(verdict.answer()),
                verdict.reason(),
                verdict.simulation(),
                verdict.trace().stream().map(Step::of).toList(),
                Reason.all(verdict.explanation()),
                verdict.notes(),
                verdict.explored());
    }

    public static String render(Verdict verdict) {
        return Json.text(of(verdict));
    }

    /** What {@code refines} answers: a verdict, or one for each configuration with its names. */
    public static String ofRefines(List<Answered> answers) {
        return answers.size() == 1 ? render(answers.get(0).verdict()) : render(answers);
    }

    /** Answers to many questions, with the names of both sides. */
    public static String render(List<Answered> answers) {
        return Json.text(answers.stream().map(Answer::of).toList());
    }

    static Map<String, Object> inputs(Letter letter) {
        Map<String, Object> inputs = new LinkedHashMap<>();
        letter.messages().forEach((port, values) -> inputs.put(port, messages(values)));
        return inputs;
    }

    static Map<String, Object> outputs(Map<String, Sent> outputs) {
        Map<String, Object> shown = new LinkedHashMap<>();
        outputs.forEach(
                (port, sent) -> {
                    if (!(sent instanceof Sent.Messages messages)) {
                        shown.put(port, "*");
                    } else if (!messages.values().isEmpty()) {
                        shown.put(port, messages(messages.values()));
                    }
                });
        return shown;
    }

    /** Event-driven, a port may carry several messages. */
    private static Object messages(List<Value> values) {
        return values.size() == 1 ? MessageJson.of(values.get(0)) : MessageJson.all(values);
    }
}
