package arcomat.cli.command.model;

import arcomat.cli.command.Command;
import arcomat.cli.option.CheckRendering;
import arcomat.cli.option.CommandResults;
import arcomat.cli.option.ReportFormat;
import arcomat.cli.option.ReportFormat.Rendering;
import arcomat.cli.option.ReportOptions;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.importing.ImportModels;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code arcomat import}: models of other languages, read once by a guest. */
@CommandLine.Command(
        name = "import",
        description = "Writes models that a guest makes of those of another language.",
        footer = {
            "  arcomat import montiarc7 --with montiarc7.jar old --out models",
            "  arcomat import montiarc7 --with montiarc7.jar old --out models --overwrite",
            "",
            "What can be read is written, in canonical form; what cannot is a finding about the"
                    + " original. Which kinds there are is up to the guests that --with names.",
            "",
            "Exit status: 0 all is written; 1 errors in originals, or in a guest; 2 wrong use,"
                    + " files that are in the way, or input that cannot be read."
        })
public final class ImportCommand extends Command {
    @Option(
            names = "--out",
            paramLabel = "DIR",
            required = true,
            description = "The folder to write, which is new or empty.")
    private String out;

    @Option(
            names = "--overwrite",
            description =
                    "Write into a folder that is there, and replace the files that have the same"
                            + " names; others stay.")
    private boolean overwrite;

    @Mixin private ReportOptions reports = new ReportOptions();

    @Parameters(index = "0", paramLabel = "KIND", description = "Of the models to read.")
    private String kind;

    @Parameters(index = "1", paramLabel = "FOLDER", description = "With the models to read.")
    private String folder;

    @Override
    protected int run(Session session) throws WrongUse {
        reports.prepare(session);
        ImportModels.Result result = session.run(new ImportModels(kind, folder, out, overwrite));
        CheckRendering findings =
                CheckRendering.refused("import", result.originals(), machineFormats());
        Rendering all =
                (format, style) ->
                        findings.text(format, style)
                                + (format == ReportFormat.text ? told(result) : "");
        reports.write(
                new CommandResults("import", all, findings.report()::reported), session, console());
        if (result.originals().hasUnreadableInput()) {
            return ExitStatus.WRONG_USE;
        }
        return result.originals().hasErrors() ? ExitStatus.FINDINGS : ExitStatus.FINE;
    }

    private String told(ImportModels.Result result) {
        return "wrote " + FindingsText.count(result.written(), "file") + " to " + out + "\n";
    }
}
