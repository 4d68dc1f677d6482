package arcomat.report.text;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.Severity;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import com.sun.management.ThreadMXBean;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;

class SnippetTest {
    /** The text from the first to the last bracket, brackets left out, is underlined. */
    private static String underlined(String marked) {
        int start = marked.indexOf('⟦');
        int end = marked.indexOf('⟧') - 1;
        SourceFile file = new SourceFile("a.arc", marked.replaceAll("[⟦⟧]", ""));
        return Snippet.render(file.span(start, end), Severity.ERROR, Style.PLAIN);
    }

    @Test
    void underlinesTheRange() {
        assertThat(underlined("one\nconnect ⟦a.b⟧ -> c;\n"))
                .isEqualTo("    2 | connect a.b -> c;\n      |         ^^^\n");
    }

    @Test
    void marksAnEmptyRangeAndTheEndOfTheFile() {
        assertThat(underlined("port ⟦⟧;")).isEqualTo("    1 | port ;\n      |      ^\n");
        assertThat(underlined("port\n⟦⟧")).isEqualTo("    2 |\n      | ^\n");
    }

    @Test
    void expandsTabs() {
        assertThat(underlined("\tport\t⟦in⟧ x"))
                .isEqualTo("    1 |     port    in x\n      |             ^^\n");
    }

    @Test
    void countsWideAndCombiningCharactersAsTerminalsDo() {
        assertThat(underlined("// 漢字 ⟦x⟧")).isEqualTo("    1 | // 漢字 x\n      |         ^\n");
        assertThat(underlined("// e\u0301 ⟦x⟧"))
                .isEqualTo("    1 | // e\u0301 x\n      |      ^\n");
        assertThat(underlined("// 🤖 ⟦x⟧")).isEqualTo("    1 | // 🤖 x\n      |       ^\n");
    }

    /** Wherever a long line is cut. */
    @Test
    void cutsNoCharacterInTwo() {
        for (int lead = 0; lead < 2; lead++) {
            String shown =
                    underlined("x".repeat(lead) + "🤖".repeat(100) + "⟦x⟧" + "🤖".repeat(100));
            assertThat(shown.codePoints().filter(c -> c >= 0xD800 && c <= 0xDFFF)).isEmpty();
        }
    }

    @Test
    void escapesWhatWouldActOnTheTerminal() {
        assertThat(underlined("\"\u001b[2J\" ⟦x⟧"))
                .isEqualTo("    1 | \"\\u001b[2J\" x\n      |             ^\n");
        assertThat(underlined("\u202e ⟦x⟧")).isEqualTo("    1 | \\u202e x\n      |        ^\n");
    }

    @Test
    void showsFirstAndLastLineOfALongRange() {
        assertThat(underlined("a ⟦{\n  b\n  c\n}⟧ d"))
                .isEqualTo("    1 | a {\n      |   ^\n      | ...\n    4 | } d\n      | ^\n");
        assertThat(underlined("a ⟦{\n⟧  b")).isEqualTo("    1 | a {\n      |   ^\n");
    }

    @Test
    void showsTheSurroundingsInAVeryLongLine() {
        String snippet = underlined("a".repeat(5000) + "⟦error⟧" + "b".repeat(5000));
        String[] lines = snippet.split("\n");
        assertThat(lines[0]).hasSizeLessThan(120).contains("aerrorb").endsWith("...");
        assertThat(lines[1].indexOf('^')).isEqualTo(lines[0].indexOf("error"));
        assertThat(lines[1]).endsWith("^^^^^");
    }

    /** Work is counted in bytes that are allocated: these do not depend on the machine. */
    @Test
    void workDoesNotGrowWithTheLengthOfTheLine() {
        long small = work(2_000);
        assertThat(work(200_000)).isLessThan(2 * small);
    }

    private static long work(int length) {
        String half = "\tfoo é ".repeat(length / 14);
        SourceFile file = new SourceFile("a.arc", "x\n" + half + "error" + half + "\ny");
        Span place = file.span(half.length() + 2, half.length() + 7);
        Span all = file.span(0, file.text().length());
        Snippet.render(place, Severity.ERROR, Style.PLAIN);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
        for (int i = 0; i < 100; i++) {
            Snippet.render(place, Severity.ERROR, Style.PLAIN);
            Snippet.render(all, Severity.ERROR, Style.PLAIN);
        }
        return threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
    }

    @Property(seed = "1")
    void neverFailsAndHasNoControlCharacters(
            @ForAll String text, @ForAll int first, @ForAll int second) {
        int start = Math.floorMod(first, text.length() + 1);
        int end = start + Math.floorMod(second, text.length() + 1 - start);
        SourceFile file = new SourceFile("a.arc", text);
        String snippet = Snippet.render(file.span(start, end), Severity.ERROR, Style.PLAIN);
        assertThat(snippet.replace("\n", "").chars().noneMatch(Character::isISOControl)).isTrue();
    }
}
