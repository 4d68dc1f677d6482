package arcomat.cli.option;

import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.ReportPage;
import arcomat.report.page.Page;

import picocli.CommandLine.Option;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** Of commands that show their results as a page, too. */
public final class PageReportOptions extends ResultOptions {
    @Option(
            names = "--report",
            paramLabel = "FORMAT=FILE|DIR",
            converter = ReportFile.ReaderOfPages.class,
            description =
                    "Also write a file in that format, or a page to look at and to step through,"
                            + " DIR/index.html; may be repeated.")
    private List<ReportFile> files = new ArrayList<>();

    @Override
    List<ReportFile> files() {
        return files;
    }

    @Override
    public void prepare(Session session) throws WrongUse {
        super.prepare(session);
        for (ReportFile each : files) {
            if (each.format().isEmpty()) {
                new ReportPage(each.file(), session.names()).requireWritable();
            }
        }
    }

    /** Writes the page, if one is wanted. */
    public void writePage(Supplier<Page> page, Session session) throws WrongUse {
        for (ReportFile each : files) {
            if (each.format().isEmpty()) {
                ReportPage.write(page.get(), each.file(), session);
            }
        }
    }
}
