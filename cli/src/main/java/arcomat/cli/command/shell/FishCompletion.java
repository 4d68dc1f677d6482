package arcomat.cli.command.shell;

import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Lines for the shell fish, which picocli does not write: a command where none is given yet, then
 * its options, and the values of those that have a list of them.
 */
final class FishCompletion {
    private final String tool;
    private final StringBuilder lines = new StringBuilder();

    private FishCompletion(String tool) {
        this.tool = tool;
    }

    static String of(CommandLine tool) {
        FishCompletion completion = new FishCompletion(tool.getCommandName());
        tool.getCommandSpec()
                .options()
                .forEach(option -> completion.add(option, "__fish_use_subcommand"));
        tool.getSubcommands().forEach((name, command) -> completion.add(command.getCommandSpec()));
        return completion.lines.toString();
    }

    private void add(CommandSpec command) {
        line(
                List.of(
                        "-n __fish_use_subcommand -f -a " + command.name(),
                        description(HelpWords.summary(command))));
        for (OptionSpec option : command.options()) {
            add(option, "'__fish_seen_subcommand_from " + command.name() + "'");
        }
        HelpWords.values(command)
                .ifPresent(
                        values ->
                                line(
                                        List.of(
                                                "-n '__fish_seen_subcommand_from "
                                                        + command.name()
                                                        + "'",
                                                "-f -a " + quoted(String.join(" ", values)))));
    }

    private void add(OptionSpec option, String condition) {
        List<String> words = new ArrayList<>(List.of("-n " + condition));
        for (String name : option.names()) {
            words.add(
                    name.startsWith("--") ? "-l " + name.substring(2) : "-s " + name.substring(1));
        }
        if (option.arity().max() > 0) {
            Optional<List<String>> values = HelpWords.values(option);
            words.add(values.map(all -> "-x -a " + quoted(String.join(" ", all))).orElse("-r"));
        }
        words.add(description(HelpWords.description(option)));
        line(words);
    }

    private static String description(String text) {
        return "-d " + quoted(text);
    }

    private static String quoted(String text) {
        return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'";
    }

    private void line(List<String> words) {
        lines.append("complete -c ").append(tool).append(' ');
        lines.append(String.join(" ", words)).append('\n');
    }
}
