package arcomat.cli;

import arcomat.pipeline.CheckResult;
import arcomat.report.FileCases;
import arcomat.report.FindingsJson;
import arcomat.report.FindingsText;
import arcomat.report.JunitXml;
import arcomat.report.Style;

/**
 * Findings in every format.
 *
 * @param command that looked at the models
 * @param strict whether a warning is a failure
 */
record CheckRendering(String command, CheckResult check, boolean strict) implements Rendering {
    @Override
    public String text(ReportFormat format, Style style) {
        return switch (format) {
            case text ->
                    FindingsText.render(check.findings(), style)
                            + FindingsText.summary(check.findings(), check.files(), style)
                            + "\n";
            case json -> FindingsJson.render(check.findings(), check.files());
            case junit ->
                    JunitXml.render(
                            "arcomat " + command,
                            FileCases.of(
                                    check.paths(), check.findings(), check.suppressed(), strict));
        };
    }
}
