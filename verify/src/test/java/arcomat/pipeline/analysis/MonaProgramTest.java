package arcomat.pipeline.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** Stand-ins for the program: whatever it does, there is a clear answer. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the stand-ins for MONA are shell scripts")
class MonaProgramTest {
    @TempDir private Path folder;

    private MonaAnswer answer(String formula, int seconds, String... script)
            throws IOException, WrongUse {
        Path program = folder.resolve("mona");
        Files.writeString(program, "#!/bin/sh\n" + String.join("\n", script) + "\n");
        assertThat(program.toFile().setExecutable(true)).isTrue();
        return MonaProgram.find("./mona", new PathNames(folder)).decide(formula, seconds);
    }

    private String noAnswer(String formula, int seconds, String... script)
            throws IOException, WrongUse {
        return ((MonaAnswer.None) answer(formula, seconds, script)).reason();
    }

    @Test
    void isNotThere() {
        assertThatThrownBy(() -> MonaProgram.find("./mona", new PathNames(folder)))
                .isInstanceOf(WrongUse.class)
                .hasMessage(
                        "there is no program './mona': install MONA (Debian's package 'mona'), name"
                                + " it with --mona, or leave '--engine mona' out");
        assertThatThrownBy(() -> MonaProgram.find("no-such-mona", new PathNames(folder)))
                .isInstanceOf(WrongUse.class);
    }

    @Test
    void getsTheFormulaAndSaysThatItIsValid() throws IOException, WrongUse {
        MonaAnswer answer =
                answer(
                        "true;",
                        10,
                        "[ \"$1\" = -q ] && [ \"$(cat \"$2\")\" = 'true;' ] || exit 1",
                        "echo 'Formula is valid'");
        assertThat(answer).isEqualTo(new MonaAnswer.Valid());
    }

    @Test
    void givesACounterexample() throws IOException, WrongUse {
        MonaAnswer answer =
                answer(
                        "false;",
                        10,
                        "echo 'A counter-example of least length (2) is:'",
                        "echo 'in_0            X 0X'",
                        "echo 'leftState0      X 01'",
                        "echo",
                        "echo 'in_0 = {}'");
        assertThat(answer)
                .isEqualTo(new MonaAnswer.Counterexample(Map.of("in_0", "0X", "leftState0", "01")));
    }

    @Test
    void givesACounterexampleWithoutEnd() throws IOException, WrongUse {
        assertThat(
                        noAnswer(
                                "false;",
                                10,
                                "echo 'A counter-example of least length (3) is:'",
                                "echo 'in_0            X 0X'"))
                .isEqualTo("MONA has given a counterexample that cannot be understood");
    }

    @Test
    void fails() throws IOException, WrongUse {
        assertThat(noAnswer("", 10, "echo \"Error in file 'x' near line 2\"", "exit 255"))
                .isEqualTo("MONA failed with exit status 255: Error in file 'x' near line 2");
        assertThat(noAnswer("", 10, "exit 3")).isEqualTo("MONA failed with exit status 3");
    }

    @Test
    void abortsOnALongText() throws IOException, WrongUse {
        assertThat(noAnswer(" ".repeat(400_000), 10, "kill -ABRT $$"))
                .isEqualTo(
                        "MONA aborted on a formula of 400000 characters; MONA 1.4-18 does so on"
                                + " long ones");
    }

    @Test
    void runsOutOfMemory() throws IOException, WrongUse {
        assertThat(noAnswer("", 10, "echo '*** out of memory, execution aborted ***'", "exit 255"))
                .isEqualTo("MONA ran out of memory, of which it gets 2048 MB");
    }

    @Test
    void getsItsShareOfMemory() throws IOException, WrongUse {
        assertThat(noAnswer("", 10, "ulimit -v; exit 1"))
                .isEqualTo("MONA failed with exit status 1: " + 2048 * 1024);
    }

    @Test
    void saysTooMuch() throws IOException, WrongUse {
        assertThat(noAnswer("", 60, "exec yes")).matches("MONA failed with exit status \\d+: y");
    }

    @Test
    void saysSomethingElse() throws IOException, WrongUse {
        assertThat(noAnswer("", 10, "echo 'I am another program'"))
                .isEqualTo("MONA has given no answer that can be understood");
    }

    @Test
    void hangsAndIsEndedWithItsChildren() throws IOException, WrongUse, InterruptedException {
        Path pulse = folder.resolve("pulse");
        String child = "while :; do echo beat >> '" + pulse + "'; sleep 0.02; done &";
        assertThat(noAnswer("", 1, child, "wait"))
                .isEqualTo(
                        "MONA has not answered after 1 second and was stopped; allow it more with"
                                + " --timeout");
        Thread.sleep(100);
        long beats = Files.size(pulse);
        Thread.sleep(300);
        assertThat(Files.size(pulse)).isPositive().isEqualTo(beats);
    }
}
