package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Shell.Outcome;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Little text that means very much. */
@Tag("distribution")
class ManyPartsTest {
    @TempDir private Path temporary;

    /** Each level has ten parts of the one below. */
    private void writeLevels(int levels) throws IOException {
        Files.writeString(
                temporary.resolve("L0.arc"),
                """
                component L0 {
                  port in Boolean x, out Boolean y;
                  automaton { state s; initial s; s {x == true} / {y = true}; }
                }
                """);
        for (int level = 1; level <= levels; level++) {
            StringBuilder text = new StringBuilder("component L" + level + " {\n");
            text.append("  port in Boolean x, out Boolean y;\n");
            for (char name = 'a'; name <= 'j'; name++) {
                text.append("  component L%d %s;\n".formatted(level - 1, name));
                text.append("  connect x -> %s.x;\n".formatted(name));
            }
            text.append("  connect a.y -> y;\n}\n");
            Files.writeString(temporary.resolve("L" + level + ".arc"), text);
        }
    }

    @Test
    @Timeout(120)
    void tooManyPartsAreRefusedByEveryCommand() throws Exception {
        writeLevels(9);
        Shell shell = new Shell(temporary);
        String[] commands = {
            "check",
            "simulate --main L9",
            "generate --target jvm --out out",
            "verify",
            "refines L9 L8"
        };
        for (String command : commands) {
            Outcome outcome = shell.run("$A " + command + " .");
            assertThat(outcome.out() + outcome.err())
                    .contains("error ARC0131: component 'L5' consists of 111,110 parts")
                    .containsOnlyOnce("ARC0131");
        }
    }

    /** What is allowed may still be more than can be compared in a moment. */
    @Test
    @Timeout(120)
    void aComparisonOfManyPartsEndsInTime() throws Exception {
        writeLevels(4);
        Files.writeString(
                temporary.resolve("Most.arc"),
                """
                component Most {
                  port in Boolean x, out Boolean y;
                  component L4 a, b, c, d, e, f, g, h;
                  connect x -> a.x, b.x, c.x, d.x, e.x, f.x, g.x, h.x;
                  connect a.y -> y;
                }
                """);
        Outcome outcome = new Shell(temporary).run("$A refines --timeout 1 Most L4 .");
        assertThat(outcome.out() + outcome.err()).contains("unknown", "the time is up");
        assertThat(outcome.status()).isEqualTo(3);
    }
}
