package arcomat.cli.option;

import arcomat.report.text.Style;

/** How results are written that a build server reads. */
public enum ReportFormat {
    text,
    json,
    sarif,
    junit,
    github;

    /** A result of a command that can be written in every format. */
    public interface Rendering {
        /**
         * @param style of the formats for people
         */
        String text(ReportFormat format, Style style);
    }
}
