package arcomat.pipeline.analysis;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Finding;
import arcomat.pipeline.Session;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.diagram.MarkedFindings;

import java.util.List;

/**
 * Findings of {@code analyze}, for pictures that mark them.
 *
 * @param limits how long to look for findings
 */
public record AutomatonFindings(AnalysisLimits limits) implements MarkedFindings {
    @Override
    public List<Marked> find(LoweredModels models, Session session) {
        return AnalyzeAutomata.examine(new InstancePromises(models).all(), models, limits, session)
                .stream()
                .map(AutomatonFindings::marked)
                .toList();
    }

    private static Marked marked(Examination examination) {
        return new Marked(
                examination.automaton(),
                examination.findings().stream().map(Finding::diagnostic).toList());
    }
}
