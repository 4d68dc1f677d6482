package arcomat.cli.option;

import arcomat.report.text.Style;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** How results are written that a build server reads. */
public enum ReportFormat {
    text,
    json,
    sarif,
    junit,
    github;

    /** The one of a name; empty where it may be that of a guest. */
    static Optional<ReportFormat> of(String name) {
        return Arrays.stream(values()).filter(each -> each.name().equals(name)).findFirst();
    }

    static List<String> names() {
        return Arrays.stream(values()).map(ReportFormat::name).toList();
    }

    /** A result of a command that can be written in every format. */
    public interface Rendering {
        /**
         * @param style of the formats for people
         */
        String text(ReportFormat format, Style style);
    }
}
