package arcomat.cli.option;

import arcomat.cli.option.ReportFormat.Rendering;
import arcomat.cli.terminal.MachineFormats;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckResult;
import arcomat.report.finding.CheckReport;
import arcomat.report.finding.FileCases;
import arcomat.report.finding.FindingsJson;
import arcomat.report.finding.FindingsText;
import arcomat.report.finding.JunitXml;
import arcomat.report.finding.JunitXml.Case;
import arcomat.report.finding.Reported;
import arcomat.report.text.Style;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Findings in every format.
 *
 * @param command that looked at the models
 * @param strict whether a warning is a failure
 */
public record CheckRendering(
        String command, CheckReport report, boolean strict, MachineFormats machine)
        implements Rendering {

    /** Of models that have errors, for a command that cannot go on. */
    public static CheckRendering refused(
            String command, CheckResult check, MachineFormats machine) {
        CheckReport report =
                new CheckReport(
                        check.paths(), check.findings(), check.suppressed(), Optional.empty());
        return new CheckRendering(command, report, false, machine);
    }

    /** With the findings about files that a command went on without. */
    public static List<Reported> withAside(List<Reported> results, Aside aside) {
        List<Reported> all = new ArrayList<>(results);
        all.addAll(report(aside).reported());
        return all;
    }

    /** With the files that a command went on without, as far as something was found in them. */
    public static List<Case> withCasesAside(List<Case> results, Aside aside) {
        List<Case> all = new ArrayList<>(results);
        all.addAll(new FileCases(report(aside), false).all());
        return all;
    }

    private static CheckReport report(Aside aside) {
        return new CheckReport(List.of(), aside.findings(), List.of(), Optional.empty());
    }

    /** To be written. */
    public CommandResults results() {
        return new CommandResults(command, this, report::reported);
    }

    @Override
    public String text(ReportFormat format, Style style) {
        return switch (format) {
            case text ->
                    FindingsText.render(report.findings(), style)
                            + FindingsText.summary(report, style);
            case json -> FindingsJson.render(report);
            case sarif -> machine.sarif(report.reported(), report.comparison().isPresent());
            case junit ->
                    JunitXml.render("arcomat " + command, new FileCases(report, strict).all());
            case github -> machine.github(report.reported(), FindingsText.summary(report, style));
        };
    }
}
