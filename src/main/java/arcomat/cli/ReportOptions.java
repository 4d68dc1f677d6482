package arcomat.cli;

import arcomat.pipeline.Pipeline;
import arcomat.pipeline.WrongUse;
import arcomat.report.Style;
import arcomat.report.page.Page;

import picocli.CommandLine.Option;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** How a command writes its result: to the console in one format, to files in any. */
final class ReportOptions {
    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "How to write results: ${COMPLETION-CANDIDATES}; default text.")
    private ReportFormat format;

    @Option(
            names = "--report",
            paramLabel = "FORMAT=FILE|DIR",
            converter = ReportFile.Reader.class,
            description = "Also write a file in that format, or a page into a folder; may be repeated.")
    private List<ReportFile> files = new ArrayList<>();

    /** Complains before any work is done in vain. */
    void prepare(Pipeline pipeline) throws WrongUse {
        for (ReportFile each : files) {
            if (each.format().isEmpty()) {
                pipeline.requireReportFolder(each.file());
            }
        }
    }

    /** Of a command that has no page: only files can be wanted. */
    void requireFiles() throws WrongUse {
        for (ReportFile each : files) {
            if (each.format().isEmpty()) {
                throw new WrongUse(
                        "'" + each.file() + "' is not FORMAT=FILE, as in junit=build/results.xml");
            }
        }
    }

    /** Writes the page, if one is wanted. */
    void writePage(Supplier<Page> page, Pipeline pipeline) throws WrongUse {
        for (ReportFile each : files) {
            if (each.format().isEmpty()) {
                pipeline.writeReport(each.file(), page.get());
            }
        }
    }

    /** Writes the files first: they are complete when the console says what happened. */
    void write(Rendering result, Pipeline pipeline, Console console) throws WrongUse {
        for (ReportFile each : files) {
            if (each.format().isPresent()) {
                pipeline.writeFile(each.file(), result.text(each.format().get(), Style.PLAIN));
            }
        }
        console.out().print(result.text(format, console.style()));
    }
}
