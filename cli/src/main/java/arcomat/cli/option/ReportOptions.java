package arcomat.cli.option;

import picocli.CommandLine.Option;

import java.util.ArrayList;
import java.util.List;

/** Of commands whose results are lists of findings. */
public final class ReportOptions extends ResultOptions {
    @Option(
            names = "--report",
            paramLabel = "FORMAT=FILE",
            converter = ReportFile.Reader.class,
            description = "Also write a file in that format; may be repeated.")
    private List<ReportFile> files = new ArrayList<>();

    @Override
    List<ReportFile> files() {
        return files;
    }
}
