package arcomat.pipeline.world;

import arcomat.pipeline.beside.BesideText;
import arcomat.pipeline.beside.BesideText.Choice;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.world.WorldParameter;
import arcomat.world.WorldParser;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What may stand at a place of a world; a browser can ask, too. */
public record WorldChoices(SourceFile text, Programs programs) {
    private static final Pattern KIND = Pattern.compile("(?m)^\\s*kind\\s+(\\S+)");

    /** Behind the name of a component, in the rest of its line. */
    private static final Pattern FOLDER = Pattern.compile("^\\S*\\s+in\\s+(\\S+)");

    /** The models of which programs can be made. */
    public interface Programs {
        /**
         * Components that are to be deployed.
         *
         * @param folder of models, as a line of the world has it; empty for all that are known
         */
        Stream<String> components(Optional<String> folder);

        /** The folders of models that have such a component, as the world would name them. */
        List<String> folders(String component);
    }

    /** Components of which programs are made: those that are to be deployed. */
    public static Stream<String> deployed(Workspace models) {
        return models.topLevelComponents().stream()
                .filter(each -> each.signature().isDeploy())
                .map(ComponentSymbol::qualifiedName);
    }

    /** As {@link BesideText#choices}. */
    public List<Choice> at(int offset) {
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
        Set<String> kinds = new LinkedHashSet<>();
        Matcher found = KIND.matcher(text.text());
        while (found.find()) {
            kinds.add(found.group(1));
        }
        return kinds.stream().map(kind -> new Choice(kind, "kind of robots")).toList();
    }

    private List<Choice> parameters() {
        return WorldParser.parameters(text).stream().map(WorldChoices::choice).toList();
    }

    private static Choice choice(WorldParameter parameter) {
        return new Choice("$" + parameter.name(), "parameter, usually " + parameter.usual());
    }

    private List<Choice> components(int start) {
        Matcher found = FOLDER.matcher(text.text().substring(start));
        Optional<String> folder = found.find() ? Optional.of(found.group(1)) : Optional.empty();
        Stream<Choice> components =
                programs.components(folder)
                        .distinct()
                        .sorted()
                        .map(name -> new Choice(name, "component"));
        return Stream.concat(components, parameters().stream()).toList();
    }

    private List<Choice> folders(List<String> line) {
        return line.size() == 4 && line.get(3).equals("in")
                ? programs.folders(line.get(2)).stream()
                        .map(folder -> new Choice(folder, "folder of models"))
                        .toList()
                : List.of();
    }
}
