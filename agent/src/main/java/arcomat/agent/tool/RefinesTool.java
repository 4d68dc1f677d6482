package arcomat.agent.tool;

import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.ComparedSides;
import arcomat.pipeline.analysis.ProveRefinement;
import arcomat.pipeline.analysis.Prover;
import arcomat.report.verdict.VerdictJson;

import java.util.List;
import java.util.Optional;

/** Whether one component keeps the promises of another. */
final class RefinesTool implements Tool {
    private static final String LEFT = "left";
    private static final String RIGHT = "right";
    private static final String MAP = "map";
    private static final String COMPLETION = "completion";

    @Override
    public String name() {
        return "refines";
    }

    @Override
    public String description() {
        return "Proves that one component keeps what another promises, in all runs, or shows a"
                + " shortest run in which it does not, step by step, with the transitions to"
                + " blame. 'unknown' comes with a reason.";
    }

    @Override
    public List<ToolParameter> parameters() {
        return List.of(
                ToolParameter.text(
                                LEFT,
                                "A component, p.Robot, or one automaton of it, p.Robot#waits.")
                        .asRequired(),
                ToolParameter.text(RIGHT, "The component whose promises the left one is to keep.")
                        .asRequired(),
                ToolParameter.text(
                        COMPLETION,
                        "What both do where no transition fits, instead of what the models say:"
                                + " LEFT,RIGHT, each chaos, output, ignore or error."),
                ToolParameter.text(
                        MAP,
                        "Where their ports differ: a component, p.Adapter, whose components Inputs"
                                + " and Outputs say how those of the left stand for those of the"
                                + " right."),
                ToolParameter.paths());
    }

    @Override
    public ToolAnswer answer(ToolCall call) throws WrongUse {
        ToolArguments told = call.arguments();
        ComparedSides sides =
                ComparedSides.of(told.required(LEFT), told.required(RIGHT), told.text(COMPLETION));
        AnalysisLimits limits = new AnalysisLimits(Optional.of(call.patience()), Optional.empty());
        ProveRefinement question =
                new ProveRefinement(
                        sides,
                        new Prover.Engine(),
                        told.text(MAP),
                        Optional.empty(),
                        call.paths(),
                        limits);
        return ToolAnswer.of(call.session().run(question), VerdictJson::ofRefines);
    }
}
