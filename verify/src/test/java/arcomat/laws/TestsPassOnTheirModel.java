package arcomat.laws;

import arcomat.analysis.coverage.TransitionTests;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.model.Component;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;
import arcomat.source.SourceFile;

import java.util.List;

/** What {@code tests} writes passes on the model that it was made from. */
final class TestsPassOnTheirModel implements Law {

    @Override
    public String name() {
        return "5 tests pass on their model";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        boolean events = draw.has(Features.EVENTS) && draw.chance(20);
        return List.of(
                ComponentText.types(),
                ComponentText.atomic(draw, "a", "Main", ComponentText.plugs(draw, events), events));
    }

    @Override
    public Outcome check(Models models) {
        Component component = models.component(Pairs.LEFT);
        TransitionTests.Result result =
                TransitionTests.of(Questions.promise(component), "Run", Questions.budget());
        for (TransitionTests.Test each : result.tests()) {
            if (StreamTests.run(each.streams()).verdict() == StreamTestResult.Verdict.FAILED) {
                String path = Recorded.path(component);
                return Outcome.broken(
                                "a generated test fails on its model",
                                "tests " + Pairs.LEFT,
                                "test " + path)
                        .with(path, Recorded.text(each.streams()));
            }
        }
        return result.tests().isEmpty() ? Outcome.SKIPPED : Outcome.KEPT;
    }
}
