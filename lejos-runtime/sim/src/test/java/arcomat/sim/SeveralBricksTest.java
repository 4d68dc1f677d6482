package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;

import org.junit.jupiter.api.Test;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;

/** Bricks in one laboratory share time and air, and nothing else. */
class SeveralBricksTest {
    private static final Program ECHO =
            Compiled.main(
                    "NXTConnection c = Bluetooth.waitForConnection(0, NXTConnection.PACKET);",
                    "byte[] packet = new byte[4];",
                    "while (c.read(packet, 4) > 0) { packet[0]++; c.write(packet, 1); }",
                    "LCD.drawString(\"over\", 0, 0);");

    private static final Program CALLER =
            Compiled.main(
                    "Delay.msDelay(200);",
                    "NXTConnection c = Bluetooth.connect(\"echo\", NXTConnection.PACKET);",
                    "byte[] packet = {41};",
                    "long start = System.currentTimeMillis();",
                    "c.write(packet, 1);",
                    "int early = c.read(packet, 1, false);",
                    "c.read(packet, 1);",
                    "LCD.drawString(early + \" \" + packet[0] + \" \"",
                    "    + (System.currentTimeMillis() - start), 0, 0);",
                    "c.close();");

    @Test
    void twoBricksTalk() {
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick echo = laboratory.place("echo", ECHO);
            SimulatedBrick caller = laboratory.place("caller", CALLER);
            laboratory.runToEnd(10_000);
            assertThat(caller.screen().get(0)).isEqualTo("0 42 62");
            assertThat(echo.screen().get(0)).isEqualTo("over");
            assertThat(laboratory.time()).isBetween(700L, 900L);
        }
    }

    /** What one laboratory's threads have just worked with is near to no other laboratory. */
    @Test
    void laboratoriesInTwoThreadsShareNoCarriers() {
        LoadedProgram program = LoadedProgram.forMany(ECHO);
        Executor here = program.carriers();
        assertThat(program.carriers()).isSameAs(here);
        assertThat(CompletableFuture.supplyAsync(program::carriers).join()).isNotSameAs(here);
    }

    @Test
    void nobodyThereMeansNull() {
        Program program =
                Compiled.main(
                        "Object none = Bluetooth.connect(\"nobody\", NXTConnection.PACKET);",
                        "Object deaf = Bluetooth.connect(\"deaf\", NXTConnection.PACKET);",
                        "Object late = Bluetooth.waitForConnection(300, NXTConnection.PACKET);",
                        "LCD.drawString(none + \" \" + deaf + \" \" + late, 0, 0);");
        try (Laboratory laboratory = new Laboratory()) {
            laboratory.place("deaf", Compiled.main("Delay.msDelay(20000);"));
            SimulatedBrick brick = laboratory.place("brick", program);
            laboratory.runUntil(8000);
            assertThat(brick.screen().get(0)).isEqualTo("null null null");
        }
    }

    private static final Program LISTENER =
            Compiled.main(
                    "NXTConnection c = Bluetooth.waitForConnection(0, NXTConnection.PACKET);",
                    "byte[] packet = new byte[5];",
                    "String parts = \"\";",
                    "for (int n = c.read(packet, 5, false); n >= 0;",
                    "     n = c.read(packet, 5, false)) {",
                    "  parts += n == 0 ? \"\" : n + \"/\" + (n + c.available(1)) + \" \";",
                    "  Delay.msDelay(1);",
                    "}",
                    "for (int row = 0; row < parts.length() / 16; row++)",
                    "  LCD.drawString(parts.substring(16 * row, 16 * row + 16), 0, row);");

    private static final Program SPEAKER =
            Compiled.main(
                    "NXTConnection c = Bluetooth.connect(\"listener\", NXTConnection.PACKET);",
                    "for (int i = 0; i < 10; i++) {",
                    "  c.write(new byte[5], 5);",
                    "  Delay.msDelay(40);",
                    "}",
                    "c.close();");

    /** On the air a packet may break; a reader that does not wait gets its parts one by one. */
    @Test
    void somePacketsArriveInTwoParts() {
        assertThat(parts(Limits.OF_THE_BRICK))
                .isEqualTo("5/5 5/5 5/5 1/5 4/4 5/5 5/5 5/5 2/5 3/3 5/5 5/5");
        assertThat(parts(Limits.NONE)).isEqualTo("5/5 5/5 5/5 5/5 5/5 5/5 5/5 5/5");
    }

    private static String parts(Limits limits) {
        try (Laboratory laboratory = new Laboratory(limits)) {
            SimulatedBrick listener = laboratory.place("listener", LISTENER);
            laboratory.place("speaker", SPEAKER);
            laboratory.runToEnd(10_000);
            return String.join(" ", listener.screen()).strip();
        }
    }

    @Test
    void whatIsStaticExistsOncePerBrick() {
        Program program =
                Compiled.source(
                        "Count",
                        """
                        public class Count {
                            static int count;
                            public static void main(String[] args) {
                                count++;
                                lejos.nxt.Motor.A.rotate(90);
                                lejos.nxt.LCD.drawInt(count, 0, 0);
                                lejos.nxt.LCD.drawInt(lejos.nxt.Motor.A.getTachoCount(), 0, 1);
                            }
                        }
                        """);
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick one = laboratory.place("one", program);
            SimulatedBrick two = laboratory.place("two", program);
            laboratory.runToEnd(10_000);
            assertThat(one.screen().subList(0, 2)).containsExactly("1", "90");
            assertThat(two.screen()).isEqualTo(one.screen());
        }
    }

    @Test
    void namesAreUnique() {
        try (Laboratory laboratory = new Laboratory()) {
            laboratory.place("echo", ECHO);
            assertThatThrownBy(() -> laboratory.place("echo", ECHO))
                    .isInstanceOf(IllegalArgumentException.class);
        }
    }
}
