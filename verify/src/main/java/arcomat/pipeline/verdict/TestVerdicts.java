package arcomat.pipeline.verdict;

import arcomat.pipeline.verdict.TextVerdict.Sheet;
import arcomat.pipeline.verdict.TextVerdict.Tone;
import arcomat.report.page.PageText;
import arcomat.report.run.StreamTestPage;
import arcomat.report.run.StreamTestText;
import arcomat.simulate.test.StreamTestResult;

import java.util.List;

/** Results of stream tests, each at its test. */
record TestVerdicts(List<StreamTestResult> results) {
    List<TextVerdict> at(List<VerdictPlace> places) {
        return places.stream()
                .filter(place -> place.kind() == VerdictPlace.Kind.TEST)
                .flatMap(
                        place ->
                                results.stream()
                                        .filter(each -> each.test().span().equals(place.subject()))
                                        .map(each -> verdict(place, each)))
                .toList();
    }

    private static TextVerdict verdict(VerdictPlace place, StreamTestResult result) {
        return new TextVerdict(
                place,
                tone(result),
                StreamTestText.line(result),
                new Sheet(
                        "index.html",
                        () ->
                                PageText.render(
                                        StreamTestPage.of(
                                                result.test().title(), List.of(result)))));
    }

    private static Tone tone(StreamTestResult result) {
        return switch (result.verdict()) {
            case PASSED -> Tone.GOOD;
            case FAILED -> Tone.BAD;
            case VACUOUS, UNKNOWN -> Tone.OPEN;
        };
    }
}
