package arcomat.cli;

import arcomat.report.text.Style;

/** A result of a command that can be written in every format. */
interface Rendering {
    /**
     * @param style of the formats for people
     */
    String text(ReportFormat format, Style style);
}
