package arcomat.cli.command.proof;

import arcomat.cli.command.ComparisonCommand;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.WriteMonaQuestion;
import arcomat.pipeline.analysis.WriteMonaQuestion.Outcome;
import arcomat.pipeline.analysis.WriteMonaQuestion.Settled;
import arcomat.pipeline.analysis.WriteMonaQuestion.Written;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.text.Style;
import arcomat.report.verdict.MonaReport;
import arcomat.report.verdict.VerdictJson;
import arcomat.report.verdict.VerdictText;

import picocli.CommandLine;
import picocli.CommandLine.Option;

/** {@code arcomat mona}: the question whether a component refines another, for the program MONA. */
@CommandLine.Command(
        name = "mona",
        description = "Writes the question whether A refines B for the program MONA.",
        footer = {
            "  arcomat mona coffee.fig5.AvoidCrash coffee.fig3.AvoidCrash --out figures.mona"
                    + " models/coffee",
            "  mona -q figures.mona",
            "",
            "'arcomat refines --engine mona' asks the program and tells its answer.",
            "Exit status: 0 written; 1 the interfaces do not fit; 3 not for MONA; 2 wrong use or",
            "models with errors. The file is written in the first case only."
        })
public final class MonaCommand extends ComparisonCommand<WriteMonaQuestion.Outcome> {
    @Option(
            names = "--out",
            paramLabel = "FILE",
            required = true,
            description = "The file to write, which is replaced.")
    private String out;

    @Override
    protected Task<CheckedAnswer<Outcome>> task(Session session) throws WrongUse {
        return new WriteMonaQuestion(sides(), out, paths(), limits());
    }

    @Override
    protected String json(Outcome outcome) {
        return outcome instanceof Written written
                ? report(written).json()
                : VerdictJson.render(((Settled) outcome).answered().verdict());
    }

    @Override
    protected String text(Outcome outcome, Style style) {
        return outcome instanceof Written written
                ? report(written).text()
                : VerdictText.render(((Settled) outcome).answered(), style);
    }

    @Override
    protected int status(Outcome outcome) {
        return outcome instanceof Settled settled
                ? status(settled.answered().verdict().answer())
                : ExitStatus.FINE;
    }

    private static MonaReport report(Written written) {
        return new MonaReport(written.file(), written.leftStates(), written.rightStates());
    }
}
