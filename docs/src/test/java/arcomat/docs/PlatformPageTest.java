package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.models.ModelFiles;
import arcomat.models.ReadModels;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The reference of the model library has every component with its parameters and ports. */
class PlatformPageTest {
    private static final Workspace LIBRARY =
            ReadModels.workspace(ModelFiles.under(ModelFiles.LIBRARY));

    @Test
    void theReferenceIsComplete() throws IOException {
        List<String> rows =
                Files.readAllLines(Path.of("docs/platform.md")).stream()
                        .filter(line -> line.startsWith("| `"))
                        .toList();
        assertThat(rows).hasSameSizeAs(LIBRARY.components());
        for (ComponentSymbol component : LIBRARY.components()) {
            assertThat(rows)
                    .filteredOn(row -> row.matches("\\| `" + component.name() + "[`<].*"))
                    .as(component.name())
                    .singleElement()
                    .satisfies(row -> assertThat(row).contains(names(component)));
        }
    }

    private static List<String> names(ComponentSymbol component) {
        return Stream.concat(
                        component.parameters().stream().map(parameter -> parameter.name()),
                        component.ports().stream().map(port -> "`" + port.name() + "`"))
                .toList();
    }
}
