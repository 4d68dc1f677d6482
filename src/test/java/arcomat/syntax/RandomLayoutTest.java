package arcomat.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.laws.draw.Plug;
import arcomat.laws.draw.VariedText;
import arcomat.source.SourceFile;
import arcomat.tree.Unit;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/** Whatever models look like, the canonical text is the same tree with the same comments. */
class RandomLayoutTest {
    private static final Set<Features> ALL = EnumSet.allOf(Features.class);

    /** Blanks, and comments of each kind; the number makes each another one. */
    private static final List<String> GAPS =
            List.of(" ", "  ", "\n", "\n\n\n", "\t", " /* %d */ ", " // %d\n", "\n/** %d */\n");

    /** A comment is one, whatever stands in it. */
    private static final Pattern WORD = Pattern.compile("/\\*.*?\\*/|\\S+");

    @Tag("slow")
    @Property(seed = "1", tries = 100)
    void layoutChangesNothingElse(@ForAll long seed) {
        Draw draw = new Draw(seed, ALL);
        for (SourceFile file : models(draw)) {
            SourceFile written = scattered(file, new Random(seed));
            assertThat(Parser.parse(written).findings()).as(written.text()).isEmpty();
            String text = FormatterTest.check(written);
            assertThat(comments(new SourceFile(file.path(), text)))
                    .as(written.text())
                    .isEqualTo(comments(written));
        }
    }

    private static List<SourceFile> models(Draw draw) {
        List<Plug> plugs = ComponentText.plugs(draw, false);
        List<SourceFile> files = new ArrayList<>();
        files.add(ComponentText.atomic(draw, "a", "Main", plugs, draw.chance(20)));
        files.addAll(VariedText.of(draw, false));
        files.addAll(VariedText.refined(draw));
        return files;
    }

    /** The same words with other gaps between them. */
    private static SourceFile scattered(SourceFile file, Random random) {
        StringBuilder text = new StringBuilder();
        List<String> words = WORD.matcher(file.text()).results().map(MatchResult::group).toList();
        for (int i = 0; i < words.size(); i++) {
            text.append(i == 0 ? "" : gap(random, i)).append(words.get(i));
        }
        return new SourceFile(file.path(), text.append('\n').toString());
    }

    private static String gap(Random random, int number) {
        return random.nextInt(4) == 0
                ? GAPS.get(random.nextInt(GAPS.size())).formatted(number)
                : " ";
    }

    private static List<String> comments(SourceFile file) {
        Unit unit = Parser.parse(file).unit().orElseThrow();
        return unit.comments().stream().map(Unit.Comment::text).map(String::strip).toList();
    }

    @Test
    void theModelsHaveWhatTheLanguageHas() {
        String all =
                IntStream.range(0, 300)
                        .mapToObj(seed -> models(new Draw(seed, ALL)))
                        .flatMap(List::stream)
                        .map(SourceFile::text)
                        .reduce("", String::concat);
        assertThat(all)
                .contains("forall v in", "exists v in", "let v =", "timing timed", "n[2]", "n[1]")
                .contains("varif (", "} else varif (", "constraint (", " refines with.Main(g = ");
    }
}
