package arcomat.diagram;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Small models and their pictures, as files: {@code Lamp.arc} looks like {@code Lamp.svg}. With
 * {@code -PrefreshGolden} the pictures are drawn anew; look at them before keeping them.
 */
class GoldenPicturesTest {
    private static final Path FOLDER = Path.of("src/test/resources/diagram");

    static Stream<Path> models() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            List<Path> models = files.filter(f -> f.toString().endsWith(".arc")).sorted().toList();
            assertThat(models).isNotEmpty();
            return models.stream();
        }
    }

    @ParameterizedTest
    @MethodSource("models")
    void looksAsItDid(Path file) throws IOException {
        String name = file.getFileName().toString();
        SourceFile source = new SourceFile(name, Files.readString(file));
        Workspace workspace =
                Workspace.of(
                        List.of(Parser.parse(source).unit().orElseThrow()),
                        Set.of(),
                        HouseLanguages.reader());
        Model model = Lowering.lower(workspace);
        Component component = model.component(name.replace(".arc", "")).orElseThrow();
        Graph graph =
                component.isComposite()
                        ? ComponentGraph.of(component, 100)
                        : AutomatonGraph.of(component, component.automata().get(0));
        String svg = SvgText.embedded(LayeredLayout.of(graph));
        Path golden = FOLDER.resolve(name.replace(".arc", ".svg"));
        if (Boolean.getBoolean("golden.refresh")) {
            Files.writeString(golden, svg);
        }
        assertThat(svg).isEqualTo(Files.readString(golden));
        assertThat(Overlaps.in(svg)).isEmpty();
    }
}
