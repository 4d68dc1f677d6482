package arcomat.pipeline.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.search.Budget;
import arcomat.model.StreamTest;
import arcomat.pipeline.Interruption;
import arcomat.pipeline.Session;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.AnalyzeAutomata;
import arcomat.pipeline.analysis.VerifyPromises;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Asks all that can be asked about one file, with the questions of {@code verify}, {@code analyze},
 * {@code test} and {@code generate}.
 *
 * @param path the file
 * @param interruption ends the work, also in the middle of a search
 */
public record AskVerdicts(String path, AnalysisLimits limits, Interruption interruption)
        implements ModelQuestion<List<TextVerdict>> {
    @Override
    public List<String> paths() {
        return List.of(path);
    }

    /** About other files nothing is asked: they may have errors where this one needs none. */
    @Override
    public Asked asked() {
        return whole -> whole.units().stream().anyMatch(this::isAbout);
    }

    private boolean isAbout(Unit unit) {
        return unit.file().path().equals(path);
    }

    @Override
    public List<TextVerdict> answer(LoweredModels models, Session session) {
        Optional<Unit> unit =
                models.checked().loaded().units().stream().filter(this::isAbout).findFirst();
        List<VerdictPlace> places = unit.map(VerdictPlaces::in).orElse(List.of());
        if (places.isEmpty()) {
            return List.of();
        }
        Budget budget = limits.budget().endingWhen(interruption::isEnded);
        List<TextVerdict> verdicts = new ArrayList<>();
        if (places.stream().anyMatch(each -> each.kind() == VerdictPlace.Kind.TEST)) {
            verdicts.addAll(new TestVerdicts(tests(models)).at(places));
        } else {
            List<Answered> promises = VerifyPromises.answers(models, budget, interruption);
            verdicts.addAll(new PromiseVerdicts(models, promises).at(places));
            AnalyzeAutomata.Found found =
                    AnalyzeAutomata.all(models, budget, session.with(interruption));
            verdicts.addAll(new AutomatonVerdicts(found).at(places));
            verdicts.addAll(new ProgramVerdicts(models, session).at(places));
        }
        interruption.goOn();
        return verdicts;
    }

    private List<StreamTestResult> tests(LoweredModels models) {
        List<StreamTestResult> results = new ArrayList<>();
        for (StreamTest test : models.model().tests()) {
            if (models.isNamed(test.span())) {
                interruption.goOn();
                results.add(StreamTests.run(test));
            }
        }
        return results;
    }
}
