package arcomat.cli.command.proof;

import arcomat.analysis.evolution.Evolution;
import arcomat.cli.command.AnalysisCommand;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.FollowEvolution;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.text.Style;
import arcomat.report.verdict.EvolutionJson;
import arcomat.report.verdict.EvolutionText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat evolution}: which edit of which version broke which promise. */
@CommandLine.Command(
        name = "evolution",
        description = "Follows promises along versions: kept or not, and which edit broke them.",
        footer = {
            "  arcomat evolution --versions p.v1.Robot,p.v2.Robot,p.v3.Robot models",
            "",
            "Exit status: 0 each version refines the one before; 1 one does not; 3 unknown;",
            "2 wrong use or models with errors."
        })
public final class EvolutionCommand extends AnalysisCommand<Evolution> {
    @Option(
            names = "--versions",
            paramLabel = "Q,Q,..",
            required = true,
            split = ",",
            hideParamSyntax = true,
            description = "Components, the oldest first.")
    private List<String> versions;

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    @Override
    protected Task<CheckedAnswer<Evolution>> task(Session session) throws WrongUse {
        if (versions.size() < 2) {
            throw new WrongUse("--versions names at least two components, the oldest first");
        }
        return new FollowEvolution(versions, paths, limits());
    }

    @Override
    protected String json(Evolution evolution) {
        return EvolutionJson.render(evolution);
    }

    @Override
    protected String text(Evolution evolution, Style style) {
        return EvolutionText.render(evolution, style);
    }

    @Override
    protected int status(Evolution evolution) {
        return status(evolution.answer());
    }
}
