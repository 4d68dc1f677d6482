package arcomat.check.stereotypes;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.law.Carrier;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** The table of stereotypes in the language reference lists all that mean something. */
class StereotypeTableTest {
    private static final Path PAGE = Path.of("docs/language.md");
    private static final String HEAD = "| stereotype | on | meaning |";

    @Test
    void hasARowForEachWithItsPlacesAndValues() throws IOException {
        List<String> rows =
                Files.readAllLines(PAGE).stream()
                        .dropWhile(line -> !line.equals(HEAD))
                        .skip(2)
                        .takeWhile(line -> !line.isEmpty())
                        .toList();

        assertThat(rows).hasSameSizeAs(KnownStereotype.ALL);
        for (KnownStereotype known : KnownStereotype.ALL) {
            assertThat(rows)
                    .as("a row that begins with: %s", beginning(known))
                    .anyMatch(row -> row.startsWith(beginning(known)));
        }
    }

    private static String beginning(KnownStereotype known) {
        return switch (known.form()) {
            case FLAG -> "| `" + known.name() + "` | " + places(known) + " | ";
            case CHOICE -> "| `" + known.name() + " = " + values(known) + places(known) + " | ";
            case MESSAGE -> "| `" + known.name() + "`, `" + known.name() + " = \"";
            case COUNT, REASON, NAME_AND_REASON, TEXT -> "| `" + known.name() + " = \"";
        };
    }

    private static String values(KnownStereotype known) {
        return known.values().stream()
                        .map(value -> '"' + value + '"')
                        .collect(Collectors.joining("`, `"))
                + "` | ";
    }

    private static String places(KnownStereotype known) {
        return Arrays.stream(Carrier.values())
                .filter(known.carriers()::contains)
                .map(Carrier::words)
                .collect(Collectors.joining(", "));
    }

    @Test
    void namesThePlacesOfStereotypes() throws IOException {
        String page = Files.readString(PAGE).replace('\n', ' ');
        for (Carrier carrier : Carrier.values()) {
            assertThat(page.substring(page.indexOf("Stereotypes may stand on")))
                    .contains(carrier.words());
        }
    }
}
