package arcomat.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** The runtime of generated code is plain Java 6 and uses only what the brick has. */
class RuntimeOnTheBrickTest {
    private static final Path RUNTIME = Path.of("lejos-runtime/rt/src/main/java");

    @Tag("slow")
    @Test
    void compilesAgainstTheBrickAndPassesTheCheck(@TempDir Path folder) throws IOException {
        SourceFile[] sources = sources().toArray(new SourceFile[0]);

        Map<String, byte[]> classes = new BrickCompiler(folder).forBrick(sources).orFail();

        BrickReport report = BrickCheck.check(Robots.jar(classes, List.of(sources)), Robots.TABLE);
        assertThat(report.findings()).isEmpty();
        assertThat(report.classes()).isGreaterThanOrEqualTo(sources.length);
    }

    static List<SourceFile> sources() throws IOException {
        List<SourceFile> sources = new ArrayList<>();
        try (Stream<Path> files = Files.walk(RUNTIME)) {
            for (Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
                String path = RUNTIME.relativize(file).toString().replace('\\', '/');
                sources.add(new SourceFile(path, Files.readString(file)));
            }
        }
        return sources;
    }
}
