package arcomat.cli;

import arcomat.pipeline.CheckResult;
import arcomat.pipeline.GateRequest;
import arcomat.pipeline.GateResult;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.WrongUse;
import arcomat.report.GateJson;
import arcomat.report.GateText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat gate}: whether components still keep what they promised. */
@CommandLine.Command(
        name = "gate",
        description = {
            "Compares every component with what it was on main: does it keep its promises?",
            "One that does not is let through only if the model says why:",
            "<<breaks = \"reason\">> on it, <<replaces = \"p.Old: reason\">> for one that is gone."
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  git worktree add ../main main",
            "  arcomat gate --base ../main/models models",
            "",
            "Exit status: 0 all keep their promises; 1 one does not; 3 one is unknown; 2 wrong use"
                    + " or models with errors."
        })
final class GateCommand extends AnalysisCommand {
    @Option(
            names = "--base",
            paramLabel = "DIR",
            required = true,
            description = "The same model root as it was: a checkout of main. May be repeated.")
    private List<String> base;

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    GateCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        GateResult result = pipeline.gate(new GateRequest(base, paths, limits()));
        if (result.gate().isEmpty()) {
            refuse("the base", String.join(", ", base), result.base());
            refuse("the new models", String.join(", ", paths), result.check());
            return ExitStatus.WRONG_USE;
        }
        print(
                isJson()
                        ? GateJson.render(result.gate().get(), result.findings())
                        : GateText.render(
                                result.gate().get(), result.findings(), console.style()));
        return status(result.gate().get().answer());
    }

    private void refuse(String side, String where, CheckResult check) {
        if (check.hasErrors()) {
            printLine("%s (%s):".formatted(side, where));
            refuse(check);
        }
    }
}
