package arcomat.cli.option;

import arcomat.cli.terminal.Console;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.report.text.Style;

import picocli.CommandLine.Option;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** How a command writes its result: to the console in one format, to files in any. */
abstract class ResultOptions {
    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "How to write results: ${COMPLETION-CANDIDATES}; default text.")
    private ReportFormat format;

    /** What is to be written beside what is printed. */
    abstract List<ReportFile> files();

    /** Writes the files first: they are complete when the console says what happened. */
    public final void write(ReportFormat.Rendering result, Session session, Console console)
            throws WrongUse {
        refuseFileOfTwo();
        for (ReportFile each : files()) {
            if (each.format().isPresent()) {
                String text = result.text(each.format().get(), Style.PLAIN);
                AtomicFile.write(each.file(), text, session.names());
            }
        }
        console.out().print(result.text(format, console.style()));
    }

    private void refuseFileOfTwo() throws WrongUse {
        Set<String> names = new HashSet<>();
        for (ReportFile each : files()) {
            if (!names.add(each.file())) {
                throw new WrongUse(
                        "two reports go to '%s'; give each a file of its own", each.file());
            }
        }
    }
}
