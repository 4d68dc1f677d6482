package arcomat.cli.command;

import arcomat.analysis.refinement.Difference;
import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.analysis.DiffResult;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.verdict.DifferenceJson;
import arcomat.report.verdict.DifferenceText;

import picocli.CommandLine;

import java.util.Optional;

/** {@code arcomat diff}: how two components compare. */
@CommandLine.Command(
        name = "diff",
        description = "Tells how the promises of two components compare, step by step.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat diff coffee.fig5.AvoidCrash coffee.fig6.AvoidCrash models/coffee",
            "",
            "Exit status: 0 equivalent; 1 different; 3 unknown; 2 wrong use or models with errors."
        })
public final class DiffCommand extends ComparisonCommand {
    public DiffCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        DiffResult result = pipeline.diff(request(Optional.empty()), paths());
        tellAside(result.check());
        if (result.difference().isEmpty()) {
            return refuse(result.check());
        }
        Difference difference = result.difference().get();
        print(
                isJson()
                        ? DifferenceJson.render(result.left(), result.right(), difference)
                        : DifferenceText.render(
                                result.left(), result.right(), difference, console.style()));
        return switch (difference.relation()) {
            case EQUIVALENT -> ExitStatus.FINE;
            case UNKNOWN -> ExitStatus.UNKNOWN;
            default -> ExitStatus.FINDINGS;
        };
    }
}
