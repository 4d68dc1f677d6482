package arcomat.sim.load;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.Laboratory;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** All classes of leJOS, and those that stand in for Java's own, can begin again. */
class LibraryRepetitionTest {
    @Test
    void everyClassThatIsLoadedOncePerBrickCanBeginAgain() throws IOException, URISyntaxException {
        ClassFiles files =
                new Redirected(new Program("none", Map.of()), true, List.of(), List.of(), false);
        Beginnings beginnings = new Beginnings(files);
        List<String> names = names();
        assertThat(names).hasSizeGreaterThan(50);
        for (String name : names) {
            byte[] file = files.find(name).orElseThrow();
            assertThat(Repetition.of(file, beginnings)).as(name).isNotEmpty();
        }
    }

    private static List<String> names() throws IOException, URISyntaxException {
        Path root =
                Path.of(
                        Laboratory.class
                                .getProtectionDomain()
                                .getCodeSource()
                                .getLocation()
                                .toURI());
        try (Stream<Path> files = Files.walk(root)) {
            return files.map(file -> root.relativize(file).toString().replace('\\', '/'))
                    .filter(file -> file.endsWith(".class"))
                    .map(file -> file.replace(".class", "").replace('/', '.'))
                    .filter(BrickLoader::isInside)
                    .filter(name -> !name.endsWith("package-info"))
                    .toList();
        }
    }
}
