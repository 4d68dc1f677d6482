package arcomat.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Every production: a text and beside it the tree that it must give. */
class ShapeTest {
    @TestFactory
    List<DynamicTest> textGivesTree() {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path path : Samples.in("shape", ".tree")) {
            tests.add(DynamicTest.dynamicTest(path.getFileName().toString(), () -> check(path)));
        }
        return tests;
    }

    private static void check(Path path) {
        Parsed parsed = Parser.parse(Samples.file(path));
        assertThat(parsed.findings()).isEmpty();
        String seen = TreeText.of(parsed.unit().orElseThrow());
        Path golden = path.resolveSibling(path.getFileName() + ".tree");
        if (Samples.REFRESH) {
            Samples.write(golden, seen);
        }
        assertThat(seen).isEqualTo(Samples.read(golden));
    }
}
