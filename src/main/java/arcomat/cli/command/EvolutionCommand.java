package arcomat.cli.command;

import arcomat.analysis.evolution.Evolution;
import arcomat.cli.terminal.Console;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.analysis.EvolutionResult;
import arcomat.pipeline.step.WrongUse;
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
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat evolution --versions p.v1.Robot,p.v2.Robot,p.v3.Robot models",
            "",
            "Exit status: 0 each version refines the one before; 1 one does not; 3 unknown;",
            "2 wrong use or models with errors."
        })
public final class EvolutionCommand extends AnalysisCommand {
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

    public EvolutionCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        if (versions.size() < 2) {
            throw new WrongUse("--versions names at least two components, the oldest first");
        }
        EvolutionResult result = pipeline.evolution(versions, paths, limits());
        tellAside(result.check());
        if (result.evolution().isEmpty()) {
            return refuse(result.check());
        }
        Evolution evolution = result.evolution().get();
        print(
                isJson()
                        ? EvolutionJson.render(evolution)
                        : EvolutionText.render(evolution, console.style()));
        return status(evolution.answer());
    }
}
