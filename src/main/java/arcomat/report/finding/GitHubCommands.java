package arcomat.report.finding;

import arcomat.report.finding.Reported.Standing;
import arcomat.report.text.Printable;
import arcomat.source.Diagnostic;
import arcomat.source.Diagnostic.Related;
import arcomat.source.Position;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Findings as workflow commands: lines that GitHub, where it runs a build, shows beside the lines
 * of the files. Findings that are suppressed or known need nobody's eye and are left out.
 */
public final class GitHubCommands {
    private GitHubCommands() {}

    public static String render(List<Reported> all, SourceRoot root) {
        return all.stream()
                .filter(each -> each.standing() == Standing.NEW)
                .map(each -> command(each, root))
                .collect(Collectors.joining());
    }

    private static String command(Reported each, SourceRoot root) {
        Diagnostic finding = each.finding();
        List<String> properties = new ArrayList<>();
        add(properties, "file", root.relative(finding.span().file().path()));
        if (!finding.span().file().text().isEmpty()) {
            addRange(properties, finding.span().startPosition(), finding.span().endPosition());
        }
        add(properties, "title", finding.code());
        return "::%s %s::%s\n"
                .formatted(
                        FindingsText.word(finding.severity()),
                        String.join(",", properties),
                        data(message(each)));
    }

    /** Columns are told of one line only: over several lines GitHub knows no end column. */
    private static void addRange(List<String> properties, Position start, Position end) {
        add(properties, "line", String.valueOf(start.line()));
        if (start.line() == end.line()) {
            add(properties, "col", String.valueOf(start.column()));
            add(properties, "endColumn", String.valueOf(end.column()));
        } else {
            add(properties, "endLine", String.valueOf(end.line()));
        }
    }

    private static String message(Reported each) {
        StringBuilder text = new StringBuilder(each.finding().message().strip());
        each.steps().forEach(step -> text.append('\n').append(step.text()));
        for (Related related : each.finding().related()) {
            text.append('\n')
                    .append(FindingsText.place(related.span()))
                    .append(": ")
                    .append(related.note());
        }
        each.finding().fix().ifPresent(fix -> text.append("\nhelp: ").append(fix.title()));
        return text.toString();
    }

    private static void add(List<String> properties, String name, String value) {
        properties.add(name + "=" + data(value).replace(":", "%3A").replace(",", "%2C"));
    }

    /** The percent sign first, or it would be escaped twice. */
    private static String data(String text) {
        return Printable.escapeKeepingLayout(text).replace("%", "%25").replace("\n", "%0A");
    }
}
