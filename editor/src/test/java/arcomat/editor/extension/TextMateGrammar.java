package arcomat.editor.extension;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A grammar by which editors colour, with those that it includes.
 *
 * @param words all words that its patterns look for
 */
record TextMateGrammar(Set<String> words) {
    private static final Path FOLDER = Path.of("editors/vscode/syntaxes");
    private static final String ENDING = ".tmLanguage.json";

    /** What a pattern has besides the words that it looks for: classes and names of characters. */
    private static final Pattern NO_WORD =
            Pattern.compile("\\[(?:\\\\.|[^\\]\\\\])*]|\\\\[pP]\\{\\w+}|\\\\.");

    private static final Pattern WORD = Pattern.compile("[A-Za-z]\\w*");
    private static final Set<String> PATTERNS = Set.of("match", "begin", "end");

    /**
     * @param name of the file, without its ending
     */
    static TextMateGrammar named(String name) {
        Map<String, JsonNode> all = all();
        Set<String> words = new TreeSet<>();
        Set<String> seen = new TreeSet<>();
        Deque<JsonNode> open = new ArrayDeque<>();
        open.add(read(FOLDER.resolve(name + ENDING)));
        while (!open.isEmpty()) {
            JsonNode grammar = open.remove();
            if (seen.add(grammar.get("scopeName").textValue())) {
                collect(grammar, words);
                included(grammar).forEach(scope -> open.add(all.get(scope)));
            }
        }
        return new TextMateGrammar(words);
    }

    /** By their scopes. */
    private static Map<String, JsonNode> all() {
        Map<String, JsonNode> grammars = new TreeMap<>();
        try (Stream<Path> files = Files.list(FOLDER)) {
            files.map(TextMateGrammar::read)
                    .forEach(each -> grammars.put(each.get("scopeName").textValue(), each));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return grammars;
    }

    private static JsonNode read(Path file) {
        try {
            return new ObjectMapper().readTree(file.toFile());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void collect(JsonNode node, Set<String> words) {
        PATTERNS.stream()
                .map(node::path)
                .filter(JsonNode::isTextual)
                .forEach(pattern -> words.addAll(words(pattern.textValue())));
        node.forEach(child -> collect(child, words));
    }

    private static Set<String> words(String pattern) {
        Set<String> words = new TreeSet<>();
        WORD.matcher(NO_WORD.matcher(pattern).replaceAll(" "))
                .results()
                .forEach(word -> words.add(word.group()));
        return words;
    }

    private static Set<String> included(JsonNode grammar) {
        Set<String> scopes = new TreeSet<>();
        grammar.findValuesAsText("include").stream()
                .map(include -> include.replaceAll("#.*", ""))
                .filter(scope -> !scope.isEmpty())
                .forEach(scopes::add);
        return scopes;
    }
}
