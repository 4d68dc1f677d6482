package arcomat.cli;

import arcomat.pipeline.Pipeline;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.page.Page;

import picocli.CommandLine.Option;

import java.util.function.Supplier;

/** What a command does that can show its result as a page. */
final class PageOption {
    @Option(
            names = "--report",
            paramLabel = "DIR",
            description = "Also write a page to look at and to step through: DIR/index.html.")
    private String folder;

    boolean isWanted() {
        return folder != null;
    }

    /** Complains before any work is done in vain. */
    void prepare(Pipeline pipeline) throws WrongUse {
        if (folder != null) {
            pipeline.requireReportFolder(folder);
        }
    }

    /** Writes the page, if one is wanted. */
    void write(Supplier<Page> page, Pipeline pipeline) throws WrongUse {
        if (folder != null) {
            pipeline.writeReport(folder, page.get());
        }
    }
}
