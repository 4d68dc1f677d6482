package arcomat.cli;

import arcomat.pipeline.Pipeline;
import arcomat.pipeline.WrongUse;
import arcomat.report.Style;

import picocli.CommandLine.Option;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

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
            paramLabel = "FORMAT=FILE",
            converter = ReportFile.Reader.class,
            description = "Also write a file in that format; may be repeated.")
    private List<ReportFile> files = new ArrayList<>();

    /** Writes the files first: they are complete when the console says what happened. */
    void write(Rendering result, Pipeline pipeline, Console console) throws WrongUse {
        Set<String> names = new HashSet<>();
        for (ReportFile each : files) {
            if (!names.add(each.file())) {
                throw new WrongUse(
                        "two reports go to '%s'; give each a file of its own"
                                .formatted(each.file()));
            }
        }
        for (ReportFile each : files) {
            pipeline.writeFile(each.file(), result.text(each.format(), Style.PLAIN));
        }
        console.out().print(result.text(format, console.style()));
    }
}
