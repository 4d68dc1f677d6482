package arcomat.cli.option;

import arcomat.pipeline.Pipeline;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.page.Page;

import picocli.CommandLine.Option;

import java.util.function.Supplier;

/** What a command does that can show its result as a page. */
public final class PageOption {
    @Option(
            names = "--report",
            paramLabel = "DIR",
            description = "Also write a page to look at and to step through: DIR/index.html.")
    private String folder;

    public boolean isWanted() {
        return folder != null;
    }

    /** Complains before any work is done in vain. */
    public void prepare(Pipeline pipeline) throws WrongUse {
        if (folder != null) {
            pipeline.requireReportFolder(folder);
        }
    }

    /** Writes the page, if one is wanted. */
    public void write(Supplier<Page> page, Pipeline pipeline) throws WrongUse {
        if (folder != null) {
            pipeline.writeReport(folder, page.get());
        }
    }
}
