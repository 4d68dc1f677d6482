package arcomat.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.jar.RobotJar;
import arcomat.check.DataFile;
import arcomat.check.Expectation;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** What a simulated brick lacks is told, in a file that says below a line what is wrong with it. */
class SimulationCheckTest {
    private static final Path SPY = Path.of("src/test/resources/brick-simulated/Spy.java");
    private static final Path EXPLAIN = Path.of("src/main/resources/explain/ARC0916.md");

    @TempDir Path folder;

    @Test
    void findsWhatTheFileExpects() throws IOException {
        DataFile data = DataFile.read(SPY);
        SourceFile[] sources = data.files().toArray(new SourceFile[0]);
        Map<String, byte[]> classes = new BrickCompiler(folder).forBrick(sources).orFail();
        List<Expectation> actual =
                obstacles(Robots.jar(classes, data.files())).stream().map(Expectation::of).toList();
        assertThat(data.withExpectations(actual))
                .isEqualTo(data.withExpectations(data.expectations()));
        assertThat(EXPLAIN).content().startsWith("# ARC0916 ");
    }

    private static List<Diagnostic> obstacles(RobotJar jar) {
        return BrickCheck.checkAlsoForSimulation(jar, Robots.TABLE).obstacles();
    }

    /** Its class would be the simulation's own, and could do what that can. */
    @Test
    void nobodyTakesThePlaceOfTheSimulation() {
        Map<String, byte[]> classes =
                new BrickCompiler(folder)
                        .forBrick(
                                new SourceFile(
                                        "arcomat/sim/Laboratory.java",
                                        "package arcomat.sim; public class Laboratory {}"))
                        .orFail();
        assertThat(obstacles(Robots.jar(classes)))
                .singleElement()
                .satisfies(
                        finding ->
                                assertThat(finding.message())
                                        .contains("lies in a package of the simulated brick"));
    }
}
