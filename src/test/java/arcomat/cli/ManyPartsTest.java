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
@Tag("slow")
class ManyPartsTest {
    @TempDir private Path temporary;

    /** Each level has ten parts of the one below. */
    private void writeLevels(int levels) throws IOException {
        Files.writeString(
                temporary.resolve("L0.arc"),
                """
                component L0 {
                  port in Boolean i, out Boolean o;
                  automaton { state s; initial s; s {i == true} / {o = true}; }
                }
                """);
        for (int level = 1; level <= levels; level++) {
            StringBuilder text = new StringBuilder("component L" + level + " {\n");
            text.append("  port in Boolean i, out Boolean o;\n");
            for (char name = 'a'; name <= 'j'; name++) {
                text.append("  component L%d %s;\n".formatted(level - 1, name));
                text.append("  connect i -> %s.i;\n".formatted(name));
            }
            text.append("  connect a.o -> o;\n}\n");
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
            assertThat(outcome.out())
                    .contains("error ARC0131: component 'L5' consists of 111,110 parts")
                    .containsOnlyOnce("ARC0131");
        }
    }

    /** What is allowed may still be more than can be compared in a moment. */
    @Test
    @Timeout(120)
    void aComparisonOfManyPartsEndsInTime() throws Exception {
        writeLevels(4);
        Outcome outcome = new Shell(temporary).run("$A refines --timeout 3 L4 L3 .");
        assertThat(outcome.out() + outcome.err()).contains("unknown", "the time is up");
        assertThat(outcome.status()).isEqualTo(3);
    }
}
