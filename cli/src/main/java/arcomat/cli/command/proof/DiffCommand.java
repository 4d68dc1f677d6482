package arcomat.cli.command.proof;

import arcomat.cli.command.ComparisonCommand;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.CompareComponents;
import arcomat.pipeline.analysis.CompareComponents.Found;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.text.Style;
import arcomat.report.verdict.DifferenceJson;
import arcomat.report.verdict.DifferenceText;

import picocli.CommandLine;

/** {@code arcomat diff}: how two components compare. */
@CommandLine.Command(
        name = "diff",
        description = "Tells how the promises of two components compare, step by step.",
        footer = {
            "  arcomat diff coffee.fig5.AvoidCrash coffee.fig6.AvoidCrash models/coffee",
            "",
            "Exit status: 0 equivalent; 1 different; 3 unknown; 2 wrong use or models with errors."
        })
public final class DiffCommand extends ComparisonCommand<CompareComponents.Found> {
    @Override
    protected Task<CheckedAnswer<Found>> task(Session session) throws WrongUse {
        return new CompareComponents(sides(), paths(), limits());
    }

    @Override
    protected String json(Found found) {
        return DifferenceJson.render(found.left(), found.right(), found.difference());
    }

    @Override
    protected String text(Found found, Style style) {
        return DifferenceText.render(found.left(), found.right(), found.difference(), style);
    }

    @Override
    protected int status(Found found) {
        return switch (found.difference().relation()) {
            case EQUIVALENT -> ExitStatus.FINE;
            case UNKNOWN -> ExitStatus.UNKNOWN;
            default -> ExitStatus.FINDINGS;
        };
    }
}
