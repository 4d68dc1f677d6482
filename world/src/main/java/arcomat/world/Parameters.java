package arcomat.world;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.world.Word.Given;
import arcomat.world.Words.Unreadable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The parameters of a world, with their values in one run. They are read before anything else, so
 * that it does not matter where in the text they are.
 */
final class Parameters {
    /** What their lines begin with. */
    static final String STATEMENT = "parameter";

    private static final String UNKNOWN = "ARC1127";
    private static final String UNUSED = "ARC1128";
    private static final Pattern USE = Pattern.compile("\\$([A-Za-z][A-Za-z0-9_]*)");

    private final Map<String, String> values;
    private final Map<String, WorldParameter> declared = new LinkedHashMap<>();
    private final Set<String> used = new LinkedHashSet<>();
    private final List<Diagnostic> findings = new ArrayList<>();

    private Parameters(Map<String, String> values) {
        this.values = values;
    }

    /**
     * @param values instead of the usual ones, by the names of parameters
     */
    static Parameters of(SourceFile file, Map<String, String> values) {
        Parameters parameters = new Parameters(values);
        for (int line = 1; line <= file.lineCount(); line++) {
            Words words = Words.ofLine(file, line);
            if (words.take(STATEMENT)) {
                parameters.declare(words);
            }
        }
        return parameters;
    }

    private void declare(Words words) {
        try {
            Span name = words.parameter("the name of a parameter");
            Span usual = words.next("its value where nobody gives another one").place();
            words.end();
            if (usual.text().indexOf('$') >= 0) {
                throw Words.broken(
                        usual, "'" + usual.text() + "' is no value: '$' begins a parameter");
            }
            WorldParameter parameter = new WorldParameter(name.text(), usual.text(), name);
            WorldParameter before = declared.putIfAbsent(parameter.name(), parameter);
            if (before != null) {
                findings.add(twice(parameter, before));
            }
        } catch (Unreadable e) {
            findings.add(e.finding());
        }
    }

    private static Diagnostic twice(WorldParameter parameter, WorldParameter before) {
        return Diagnostic.error(
                        KindDraft.TWICE,
                        parameter.place(),
                        "there are two parameters '" + parameter.name() + "'")
                .withRelated(before.place(), "the first one");
    }

    /** In the order of the text. */
    List<WorldParameter> all() {
        return List.copyOf(declared.values());
    }

    /** What is wrong with them; also, once the whole text is read, who is used nowhere. */
    List<Diagnostic> findings() {
        List<Diagnostic> all = new ArrayList<>(findings);
        declared.values().stream()
                .filter(parameter -> !used.contains(parameter.name()))
                .map(Parameters::unused)
                .forEach(all::add);
        return all;
    }

    private static Diagnostic unused(WorldParameter parameter) {
        return Diagnostic.error(
                UNUSED,
                parameter.place(),
                "'$%s' stands nowhere: another value of '%s' would change nothing"
                        .formatted(parameter.name(), parameter.name()));
    }

    /** What is written at a place, with the values of parameters. */
    Word read(Span place) throws Unreadable {
        Matcher matcher = USE.matcher(place.text());
        StringBuilder text = new StringBuilder();
        int read = 0;
        List<Given> given = new ArrayList<>();
        while (matcher.find()) {
            Span use =
                    place.file()
                            .span(place.start() + matcher.start(), place.start() + matcher.end());
            Given value = value(matcher.group(1), use);
            given.add(value);
            text.append(place.text(), read, matcher.start()).append(value.value());
            read = matcher.end();
        }
        return new Word(text + place.text().substring(read), place, given);
    }

    private Given value(String name, Span use) throws Unreadable {
        used.add(name);
        WorldParameter parameter = declared.get(name);
        if (parameter == null) {
            throw new Unreadable(Diagnostic.error(UNKNOWN, use, unknown(name)));
        }
        return new Given(parameter, values.getOrDefault(name, parameter.usual()));
    }

    private String unknown(String name) {
        String known =
                declared.isEmpty()
                        ? "write 'parameter %s VALUE' at the top".formatted(name)
                        : "known: " + String.join(", ", declared.keySet());
        return "there is no parameter '" + name + "'; " + known;
    }
}
