package arcomat.pipeline.check;

import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A component as a command names it: {@code p.Robot(3, "left")}, or {@code p.Lamp(dimmer = true)}
 * where it has features.
 *
 * @param name of one of its configurations where all its features are chosen, in any order
 * @param arguments for its parameters, as written
 */
record WrittenComponent(String name, List<String> arguments) {
    private static final Pattern WRITTEN = Pattern.compile("\\s*([^(]*?)\\s*(?:\\((.*)\\)\\s*)?");
    private static final Pattern ARGUMENT =
            Pattern.compile("\\s*(\"[^\"]*\"|'[^']*'|[^,\"']*?)\\s*(,|$)");

    WrittenComponent {
        arguments = List.copyOf(arguments);
    }

    /** Empty for what is no name at all. */
    static Optional<WrittenComponent> parse(String written, Workspace models) {
        Matcher matcher = WRITTEN.matcher(written);
        return matcher.matches()
                ? Optional.of(of(matcher.group(1), split(matcher.group(2)), models))
                : Optional.empty();
    }

    private static WrittenComponent of(String name, List<String> given, Workspace models) {
        for (ComponentSymbol component : models.components(name)) {
            for (ComponentSymbol each : models.configurations(component)) {
                List<String> rest = new ArrayList<>(given);
                boolean chosen =
                        each.declaration().configuration().choices().entrySet().stream()
                                .allMatch(
                                        choice ->
                                                rest.removeIf(
                                                        text ->
                                                                isChoice(
                                                                        text,
                                                                        choice.getKey(),
                                                                        choice.getValue())));
                if (chosen) {
                    return new WrittenComponent(each.qualifiedName(), rest);
                }
            }
        }
        return new WrittenComponent(name, given);
    }

    private static boolean isChoice(String text, String feature, boolean choice) {
        return text.replaceAll("\\s*=\\s*", "=").equals(feature + "=" + choice);
    }

    private static List<String> split(String arguments) {
        List<String> parts = new ArrayList<>();
        if (arguments == null || arguments.isBlank()) {
            return parts;
        }
        Matcher matcher = ARGUMENT.matcher(arguments);
        int at = 0;
        while (at <= arguments.length() && matcher.find(at)) {
            parts.add(matcher.group(1));
            at = matcher.group(2).isEmpty() ? arguments.length() + 1 : matcher.end();
        }
        return parts;
    }

    /** The components of the name. */
    List<ComponentSymbol> symbols(Workspace models) {
        int bracket = name.indexOf('(');
        return models.components(bracket < 0 ? name : name.substring(0, bracket)).stream()
                .flatMap(
                        each ->
                                bracket < 0
                                        ? List.of(each).stream()
                                        : models.configurations(each).stream())
                .filter(each -> each.qualifiedName().equals(name))
                .toList();
    }
}
