package arcomat.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Damaged texts: always a tree or findings within the text, never an exception. */
class MutationTest {
    private static final String NOISE = "{}()[]<>;,.:-+*/=!&|?@#\"' \n\u00e9\ud83d\ude00a1";
    private static final List<Path> SAMPLES = Samples.in("shape", ".tree");

    @TestFactory
    List<DynamicTest> cutAnywhere() {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path path : SAMPLES) {
            tests.add(DynamicTest.dynamicTest(path.getFileName().toString(), () -> cut(path)));
        }
        return tests;
    }

    private static void cut(Path path) {
        String text = Samples.read(path);
        for (int end = 0; end < text.length(); end++) {
            check(new SourceFile(path.getFileName().toString(), text.substring(0, end)));
        }
    }

    @Property(seed = "1", tries = 600)
    void damaged(@ForAll("samples") Path path, @ForAll long seed) {
        StringBuilder text = new StringBuilder(Samples.read(path));
        Random random = new Random(seed);
        for (int i = random.nextInt(4); i >= 0; i--) {
            damage(text, random);
        }
        check(new SourceFile(path.getFileName().toString(), text.toString()));
    }

    @Provide
    Arbitrary<Path> samples() {
        return Arbitraries.of(SAMPLES);
    }

    private static void damage(StringBuilder text, Random random) {
        int from = random.nextInt(text.length());
        int to = Math.min(text.length(), from + random.nextInt(12));
        switch (random.nextInt(3)) {
            case 0 -> text.delete(from, to);
            case 1 -> text.insert(from, NOISE.charAt(random.nextInt(NOISE.length())));
            default -> text.insert(random.nextInt(text.length()), text.substring(from, to));
        }
    }

    private static void check(SourceFile file) {
        Parsed parsed = Parser.parse(file);
        assertThat(parsed.unit().isPresent()).isEqualTo(parsed.findings().isEmpty());
        for (Diagnostic finding : parsed.findings()) {
            assertThat(finding.span().start()).isBetween(0, finding.span().end());
            assertThat(finding.span().end()).isLessThanOrEqualTo(file.text().length());
        }
        if (parsed.unit().isPresent()) {
            FormatterTest.check(file);
        } else {
            assertThat(Formatter.format(file).text()).isEmpty();
        }
    }
}
