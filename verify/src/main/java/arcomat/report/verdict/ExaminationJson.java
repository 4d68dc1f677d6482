package arcomat.report.verdict;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Examination.Unexamined;
import arcomat.analysis.search.Moment;
import arcomat.report.finding.FindingsJson;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;

import com.fasterxml.jackson.annotation.JsonUnwrapped;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** Findings about automata for programs: one entry per automaton, with a verdict. */
public record ExaminationJson(
        String component,
        String automaton,
        String title,
        String verdict,
        String reason,
        List<Finding> findings,
        Explored explored) {

    record Explored(int configurations) {}

    /** With the shortest run to where it is seen. */
    record Finding(@JsonUnwrapped FindingsJson.Finding finding, List<Step> trace) {
        static Finding of(arcomat.analysis.automaton.Finding finding) {
            Stream<Step> last = finding.witness().stream().map(Step::last);
            return new Finding(
                    FindingsJson.Finding.of(finding.diagnostic()),
                    Stream.concat(finding.trace().stream().map(Step::of), last).toList());
        }
    }

    /** The last one has an input only, where the finding is about what may follow it. */
    record Step(Map<String, Object> in, Optional<Map<String, Object>> out, Optional<String> state) {
        static Step of(Moment moment) {
            return new Step(
                    VerdictJson.inputs(moment.input()),
                    Optional.of(VerdictJson.outputs(moment.outputs())),
                    Optional.of(moment.left()));
        }

        static Step last(arcomat.model.Letter input) {
            return new Step(VerdictJson.inputs(input), Optional.empty(), Optional.empty());
        }
    }

    public static String render(List<Examination> examinations, List<Unexamined> unexamined) {
        return Json.text(
                Stream.concat(
                                examinations.stream().map(ExaminationJson::of),
                                unexamined.stream().map(ExaminationJson::of))
                        .toList());
    }

    private static ExaminationJson of(Examination examination) {
        return new ExaminationJson(
                examination.component().qualifiedName(),
                examination.automaton().name(),
                ExaminationText.title(examination),
                Printable.word(examination.answer()),
                examination.obstacle(),
                examination.findings().stream().map(Finding::of).toList(),
                new Explored(examination.explored()));
    }

    private static ExaminationJson of(Unexamined unexamined) {
        return new ExaminationJson(
                unexamined.component(),
                "",
                unexamined.component(),
                "unknown",
                unexamined.reason(),
                List.of(),
                new Explored(0));
    }
}
