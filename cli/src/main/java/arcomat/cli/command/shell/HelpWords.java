package arcomat.cli.command.shell;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What the help says, as words that are not yet laid out in lines. */
final class HelpWords {
    private static final String CANDIDATES = "${COMPLETION-CANDIDATES}";

    private HelpWords() {}

    /** What a command does. */
    static String summary(CommandSpec command) {
        return String.join(" ", command.usageMessage().description());
    }

    static String description(ArgSpec argument) {
        String text = String.join(" ", argument.description());
        return text.replace(CANDIDATES, String.join(", ", values(argument).orElse(List.of())));
    }

    /** All values that an option or a parameter can have; empty where nobody can list them. */
    static Optional<List<String>> values(ArgSpec argument) {
        return values(argument.completionCandidates());
    }

    private static Optional<List<String>> values(@Nullable Iterable<String> candidates) {
        if (candidates == null) {
            return Optional.empty();
        }
        List<String> values = new ArrayList<>();
        candidates.forEach(values::add);
        return Optional.of(values);
    }

    /** All values that the parameters of a command can have. */
    static Optional<List<String>> values(CommandSpec command) {
        return command.positionalParameters().stream()
                .map((PositionalParamSpec each) -> values(each))
                .flatMap(Optional::stream)
                .findFirst();
    }
}
