package arcomat.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.GeneratedFile;
import arcomat.generate.Monitors;
import arcomat.generate.Target;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.source.SourceFile;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Monitors are plain Java 6 and use only what the brick has, and what works there. */
class MonitorsOnTheBrickTest {
    @TempDir private Path folder;

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"requirements, p.Door", "lively, p.Lively", "lively, p.Chatty", "events, p.Bell"})
    void passTheCheckWithoutAWarning(String file, String name) throws IOException {
        Path models = Path.of("src/test/resources/monitors", file + ".txt");
        Component watched =
                Lowering.lower(Scenario.read(models).workspace()).component(name).orElseThrow();
        List<SourceFile> sources = new ArrayList<>(RuntimeOnTheBrickTest.sources());
        Target jvm = Target.shipped("jvm").orElseThrow();
        for (GeneratedFile each : Monitors.generate(watched, watched.automata(), jvm).files()) {
            sources.add(new SourceFile(each.path(), each.text()));
        }

        Map<String, byte[]> classes =
                new BrickCompiler(folder).forBrick(sources.toArray(new SourceFile[0])).orFail();

        BrickReport report = BrickCheck.check(Robots.jar(classes, sources), Robots.TABLE);
        assertThat(report.findings()).isEmpty();
        String some = watched.packageName() + "/logic/" + watched.name() + "Monitor";
        assertThat(classes).containsKey(some);
    }
}
