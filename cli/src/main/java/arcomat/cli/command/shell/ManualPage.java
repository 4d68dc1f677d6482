package arcomat.cli.command.shell;

import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

import java.util.List;
import java.util.Locale;

/**
 * The help of a command as a page of the manual, in the macros of man(7). Letters that these take
 * for something else are escaped, and what is an example stays in its lines.
 */
final class ManualPage {
    private static final String STATUS = "Exit status: ";

    private final StringBuilder page = new StringBuilder();

    private ManualPage() {}

    /** Where the page of a command lies in a folder of the manual. */
    static String file(CommandSpec command) {
        return name(command) + ".1";
    }

    private static String name(CommandSpec command) {
        return command.qualifiedName("-");
    }

    /**
     * @param version of the tool
     */
    static String of(CommandSpec command, String version) {
        ManualPage manual = new ManualPage();
        manual.head(command, version);
        manual.parameters(command);
        manual.options(command);
        manual.commands(command);
        manual.footer(List.of(command.usageMessage().footer()));
        return manual.page.toString();
    }

    private void head(CommandSpec command, String version) {
        String title = name(command).toUpperCase(Locale.ROOT);
        page.append(".TH \"" + text(title) + "\" 1 \"\" \"arcomat " + version + "\" \"Arcomat\"\n");
        section("NAME");
        String summary = HelpWords.summary(command);
        line(text(name(command)) + " \\- " + text(summary));
        section("SYNOPSIS");
        page.append(".ad l\n.nh\n");
        String synopsis = new Help(command, Help.defaultColorScheme(Ansi.OFF)).synopsis(0);
        line(text(synopsis.replaceAll("\\s+", " ").strip()));
        page.append(".ad\n");
        section("DESCRIPTION");
        line(text(summary));
    }

    private void parameters(CommandSpec command) {
        if (!command.positionalParameters().isEmpty()) {
            section("PARAMETERS");
            for (PositionalParamSpec each : command.positionalParameters()) {
                item(each.paramLabel(), HelpWords.description(each));
            }
        }
    }

    private void options(CommandSpec command) {
        section("OPTIONS");
        for (OptionSpec each : command.options()) {
            String value = each.arity().max() > 0 ? "=" + each.paramLabel() : "";
            item(String.join(", ", each.names()) + value, HelpWords.description(each));
        }
    }

    private void commands(CommandSpec command) {
        if (!command.subcommands().isEmpty()) {
            section("COMMANDS");
            command.subcommands()
                    .values()
                    .forEach(
                            each -> {
                                CommandSpec spec = each.getCommandSpec();
                                item(name(spec) + "(1)", HelpWords.summary(spec));
                            });
        }
    }

    /** Examples begin with blanks, and the exit status with its words; all else are remarks. */
    private void footer(List<String> lines) {
        section("EXAMPLES");
        StringBuilder paragraph = new StringBuilder();
        for (String each : lines) {
            if (each.isBlank() || each.startsWith(" ")) {
                remark(paragraph);
            }
            if (each.startsWith(" ")) {
                example(each);
            } else {
                paragraph.append(paragraph.isEmpty() ? "" : " ").append(each.strip());
            }
        }
        remark(paragraph);
    }

    private void example(String text) {
        page.append(".nf\n");
        line(text(text));
        page.append(".fi\n");
    }

    private void remark(StringBuilder paragraph) {
        String whole = paragraph.toString();
        paragraph.setLength(0);
        int status = whole.indexOf(STATUS);
        String remark = status < 0 ? whole : whole.substring(0, status);
        if (!remark.isBlank()) {
            page.append(".PP\n");
            line(text(remark.strip()));
        }
        if (status >= 0) {
            section("EXIT STATUS");
            line(text(whole.substring(status + STATUS.length())));
        }
    }

    private void section(String title) {
        page.append(".SH ").append(title).append('\n');
    }

    private void item(String term, String description) {
        page.append(".TP\n\\fB").append(text(term)).append("\\fR\n");
        line(text(description));
    }

    /** A line that begins with a control character would be a request. */
    private void line(String text) {
        boolean request = text.startsWith(".") || text.startsWith("'");
        page.append(request ? "\\&" : "").append(text).append('\n');
    }

    private static String text(String plain) {
        return plain.replace("\\", "\\e").replace("-", "\\-");
    }
}
