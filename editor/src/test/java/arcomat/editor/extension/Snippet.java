package arcomat.editor.extension;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A piece of text that an editor offers to be filled in.
 *
 * @param prefix what is typed to get it
 * @param text as it is where nobody fills in anything
 */
record Snippet(String prefix, String text) {
    /** The first of some choices, or what stands there until it is overwritten. */
    private static final Pattern PLACE =
            Pattern.compile("\\$\\{\\w+\\|([^,|]*)[^}]*}|\\$\\{\\w+:([^}]*)}|\\$\\d+");

    static List<Snippet> of(Path file) throws IOException {
        List<Snippet> snippets = new ArrayList<>();
        for (JsonNode each : new ObjectMapper().readTree(file.toFile())) {
            snippets.add(new Snippet(each.get("prefix").textValue(), filled(each.get("body"))));
        }
        return snippets;
    }

    private static String filled(JsonNode body) {
        List<String> lines = new ArrayList<>();
        if (body.isTextual()) {
            lines.add(body.textValue());
        }
        body.forEach(line -> lines.add(line.textValue()));
        return PLACE.matcher(String.join("\n", lines) + "\n")
                .replaceAll(
                        place ->
                                Matcher.quoteReplacement(inserted(place.group(1), place.group(2))));
    }

    private static String inserted(String choice, String usual) {
        if (choice != null) {
            return choice;
        }
        return usual == null ? "" : usual;
    }
}
