package arcomat.live;

import arcomat.live.json.JsonText;
import arcomat.model.StreamTest;
import arcomat.pipeline.check.LoweredModels;
import arcomat.report.run.StreamTestText;
import arcomat.report.text.Style;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;

import java.util.List;
import java.util.Locale;

/** What came of the stream tests, in the words of {@code arcomat test}. */
final class TestAnswers {
    private TestAnswers() {}

    static String of(LoweredModels models) {
        List<StreamTestResult> results =
                models.model().tests().stream()
                        .filter(test -> models.isNamed(test.span()))
                        .map(StreamTests::run)
                        .toList();
        return JsonText.object(
                json -> {
                    json.field("text", StreamTestText.render(results, Style.PLAIN));
                    json.objects("answers", results, TestAnswers::result);
                });
    }

    private static void result(JsonText json, StreamTestResult result) {
        StreamTest test = result.test();
        json.field("answer", result.verdict().name().toLowerCase(Locale.ROOT));
        json.field("text", StreamTestText.render(List.of(result), Style.PLAIN));
        ModelAnswers.place(json, test.span());
    }
}
