package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/** The page about editors has a row for each command in the palette of VS Code, in its order. */
class EditorsPageTest {
    private static final Pattern ROW = Pattern.compile("(?m)^\\| `(Arcomat: [^`]+)` \\|");

    @Test
    void namesWhatThePaletteOffers() throws IOException {
        JsonNode offered =
                new ObjectMapper()
                        .readTree(Path.of("editors/vscode/package.json").toFile())
                        .get("contributes");
        Set<String> hidden = new TreeSet<>();
        for (JsonNode each : offered.get("menus").get("commandPalette")) {
            if (each.get("when").textValue().equals("false")) {
                hidden.add(each.get("command").textValue());
            }
        }
        List<String> titles = new ArrayList<>();
        for (JsonNode each : offered.get("commands")) {
            if (!hidden.contains(each.get("command").textValue())) {
                titles.add("Arcomat: " + each.get("title").textValue());
            }
        }
        String page = Files.readString(Path.of("docs/editors.md"));
        assertThat(ROW.matcher(page).results().map(row -> row.group(1))).isEqualTo(titles);
    }
}
