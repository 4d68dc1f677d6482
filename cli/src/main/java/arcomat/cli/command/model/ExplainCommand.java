package arcomat.cli.command.model;

import arcomat.cli.command.Command;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Explanations;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Parameters;

/** {@code arcomat explain}: why a law exists and how to keep it. */
@CommandLine.Command(
        name = "explain",
        description =
                "Tells why a law exists, with a bad and a good model; without CODE lists all.",
        footer = {
            "  arcomat explain ARC0104",
            "  arcomat explain                          lists every code with its title",
            "",
            "Exit status: 0 explained; 2 there is no such code."
        })
public final class ExplainCommand extends Command {
    @Parameters(
            paramLabel = "CODE",
            arity = "0..1",
            description = "Code of a finding, such as ARC0104.")
    private String code;

    @Override
    protected int run(Session session) throws WrongUse {
        if (code == null) {
            Explanations.titles(session).forEach((name, title) -> printLine(name + "  " + title));
            return ExitStatus.FINE;
        }
        String page =
                Explanations.page(code, session)
                        .orElseThrow(
                                () ->
                                        new WrongUse(
                                                "there is no finding with the code '%s'; 'arcomat"
                                                        + " explain' lists all codes",
                                                code));
        print(FindingsText.explanation(page, console().style()));
        return ExitStatus.FINE;
    }
}
