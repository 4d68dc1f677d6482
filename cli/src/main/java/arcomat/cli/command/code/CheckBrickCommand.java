package arcomat.cli.command.code;

import arcomat.brick.BrickReport;
import arcomat.cli.command.Command;
import arcomat.cli.option.OutputFormat;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.brick.JarReader;
import arcomat.report.brick.BrickReportJson;
import arcomat.report.brick.BrickReportText;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Option;

/** {@code arcomat check-brick}: whether a robot's jar fits on the brick. */
@CommandLine.Command(
        name = "check-brick",
        description = "Checks a robot's jar against what the brick has and can hold.",
        footer = {
            "  arcomat check-brick --jar build/brick/Fetcher.jar",
            "  arcomat check-brick --format json --jar build/brick/Fetcher.jar > brick.json",
            "",
            "'arcomat generate' and 'arcomat link' check every jar, too.",
            "",
            "Exit status: 0 it fits on the brick; 1 it does not; 2 wrong use."
        })
public final class CheckBrickCommand extends Command {
    @Option(
            names = "--jar",
            paramLabel = "ROBOT.jar",
            required = true,
            description = "The program, as 'generate --target lejos' makes it.")
    private String jar;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "${COMPLETION-CANDIDATES}; default text.")
    private OutputFormat format;

    @Override
    protected int run(Session session) throws WrongUse {
        BrickReport report = JarReader.read(jar, session.names()).report();
        if (format == OutputFormat.json) {
            print(BrickReportJson.render(report));
        } else {
            tell(report);
        }
        return report.fits() ? ExitStatus.FINE : ExitStatus.FINDINGS;
    }

    private void tell(BrickReport report) {
        print(FindingsText.render(report.findings(), console().style()));
        print(BrickReportText.render(report, console().style()));
        printLine("'" + jar + "' " + (report.fits() ? "fits" : "does not fit") + " on the brick");
    }
}
