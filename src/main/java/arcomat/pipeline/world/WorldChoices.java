package arcomat.pipeline.world;

import arcomat.pipeline.beside.BesideText;
import arcomat.pipeline.beside.BesideText.Choice;
import arcomat.pipeline.beside.TextsAround;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.SourceFile;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.world.WorldParameter;
import arcomat.world.WorldParser;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What may stand at a place of a world.
 *
 * @param place of the file, absolute
 */
record WorldChoices(SourceFile text, Path place, TextsAround around) {
    private static final Pattern KIND = Pattern.compile("(?m)^\\s*kind\\s+(\\S+)");

    /** Behind the name of a component, in the rest of its line. */
    private static final Pattern FOLDER = Pattern.compile("^\\S*\\s+in\\s+(\\S+)");

    List<Choice> at(int offset) {
        SourceFile before = BesideText.before(text, offset);
        List<String> line = BesideText.lastLine(before);
        List<Choice> words = Choice.words(WorldParser.choicesAfter(before));
        return words.isEmpty() && !line.isEmpty() ? names(line, before.text().length()) : words;
    }

    /** Behind some words, where the language has none of its own. */
    private List<Choice> names(List<String> line, int start) {
        String first = line.get(0);
        int kindAt = first.equals("robots") ? 3 : 2;
        if (first.startsWith("robot") && line.size() == kindAt) {
            return kinds();
        }
        if (first.equals("program") && line.get(1).equals("component")) {
            return line.size() == 2 ? components(start) : folders(line);
        }
        return first.equals(WorldParser.PARAMETER) || isNameOf(line) ? List.of() : parameters();
    }

    /** Whether a name is to be made up, which is the same in all runs. */
    private static boolean isNameOf(List<String> line) {
        return line.size() == 1
                        && List.of("kind", "robot", "drinker", "thing").contains(line.get(0))
                || line.size() == 2 && line.get(0).equals("robots");
    }

    private List<Choice> kinds() {
        return KIND.matcher(text.text())
                .results()
                .map(found -> new Choice(found.group(1), "kind of robots"))
                .distinct()
                .toList();
    }

    private List<Choice> parameters() {
        return WorldParser.parameters(text).stream().map(WorldChoices::choice).toList();
    }

    private static Choice choice(WorldParameter parameter) {
        return new Choice("$" + parameter.name(), "parameter, usually " + parameter.usual());
    }

    /** Programs are made of those that are to be deployed. */
    private List<Choice> components(int start) {
        Stream<Choice> components =
                modelsFor(start).stream()
                        .flatMap(models -> deployed(models, name -> true))
                        .distinct()
                        .sorted()
                        .map(name -> new Choice(name, "component"));
        return Stream.concat(components, parameters().stream()).toList();
    }

    /** Of the folder that the line names, if it does; else of whatever is known. */
    private Collection<OpenModels> modelsFor(int start) {
        Optional<MatchResult> folder =
                FOLDER.matcher(text.text().substring(start)).results().findFirst();
        return folder.isPresent()
                ? around.models(folder().resolve(folder.get().group(1)).normalize()).stream()
                        .toList()
                : around.all();
    }

    private static Stream<String> deployed(OpenModels models, Predicate<String> wanted) {
        return models.workspace().topLevelComponents().stream()
                .filter(each -> each.signature().isDeploy())
                .map(ComponentSymbol::qualifiedName)
                .filter(wanted);
    }

    private List<Choice> folders(List<String> line) {
        if (line.size() != 4 || !line.get(3).equals("in")) {
            return List.of();
        }
        List<Choice> folders = new ArrayList<>();
        for (OpenModels models : around.all()) {
            if (deployed(models, line.get(2)::equals).findAny().isPresent()) {
                String path = folder().relativize(models.root()).toString().replace('\\', '/');
                folders.add(new Choice(path.isEmpty() ? "." : path, "folder of models"));
            }
        }
        return folders;
    }

    private Path folder() {
        return Objects.requireNonNull(place.getParent());
    }
}
