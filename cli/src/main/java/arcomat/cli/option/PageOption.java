package arcomat.cli.option;

import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.ReportPage;
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
    public void prepare(Session session) throws WrongUse {
        if (folder != null) {
            new ReportPage(folder, session.names()).requireWritable();
        }
    }

    /** Writes the page, if one is wanted. */
    public void write(Supplier<Page> page, Session session) throws WrongUse {
        if (folder != null) {
            ReportPage.write(page.get(), folder, session);
        }
    }
}
