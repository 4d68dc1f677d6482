package arcomat.cli.option;

import arcomat.cli.option.ReportFormat.Rendering;
import arcomat.report.finding.Reported;

import java.util.List;
import java.util.function.Supplier;

/**
 * What a command has to show.
 *
 * @param command that was called
 * @param rendering in the tool's own formats
 * @param findings for forms that others bring
 */
public record CommandResults(
        String command, Rendering rendering, Supplier<List<Reported>> findings) {}
