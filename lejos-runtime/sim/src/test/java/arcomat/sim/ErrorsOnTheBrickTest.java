package arcomat.sim;

import static arcomat.sim.LimitedPrograms.number;
import static arcomat.sim.LimitedPrograms.run;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.MotorOrder;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** What nothing catches ends a program, and is shown as on the brick. */
class ErrorsOnTheBrickTest {
    @Test
    void anErrorThatNothingCatchesIsShownAsOnTheBrick() {
        SimulatedBrick brick =
                run(
                        "LCD.drawString(\"before\", 0, 3);",
                        "Motor.A.forward();",
                        "new Thread() { public void run() {",
                        "  Delay.msDelay(100);",
                        "  throw new IllegalStateException(\"oops\"); } }.start();",
                        "Delay.msDelay(1000);",
                        "Motor.A.backward();");
        assertThat(brick.outcome().failure().orElseThrow()).contains("oops");
        assertThat(brick.screen()).isEqualTo(rows("Exception: 31", "oops"));
        assertThat(brick.motor(MotorName.A).order()).isEqualTo(MotorOrder.FLOAT);
        SimulatedBrick own = run("class Own extends RuntimeException { } throw new Own();");
        assertThat(own.screen()).isEqualTo(rows("Exception: ?"));
        SimulatedBrick ideal = run(Limits.NONE, Compiled.main("throw new Error();"));
        assertThat(ideal.screen()).isEqualTo(rows());
    }

    @Test
    void anErrorThatFailsToSayWhatItIsEndsTheProgramToo() {
        SimulatedBrick brick =
                run(
                        "class Own extends RuntimeException {",
                        "  public String getMessage() { throw new Error(); } }",
                        "new Thread() { public void run() { Delay.msDelay(100000); } }.start();",
                        "throw new Own();");
        assertThat(brick.outcome().kind()).isEqualTo(Outcome.Kind.FAILED);
        assertThat(brick.outcome().failure().orElseThrow()).startsWith("Main$1Own at Main.main");
        assertThat(brick.screen()).isEqualTo(rows("Exception: ?"));
    }

    private static List<String> rows(String... first) {
        List<String> rows = new java.util.ArrayList<>(List.of(first));
        while (rows.size() < 8) {
            rows.add("");
        }
        return rows;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "27: int x = 1 / (args == null ? 0 : 1);",
                "16: args[0] = null;",
                "28: int[] x = new int[3]; x[3] = 1;",
                "35: Object x = new int[args == null ? -1 : 1];",
                "26: Object x = \"\"; ((Integer) x).intValue();",
                "34: Object[] x = new String[1]; x[0] = Integer.valueOf(1);",
                "3: int[] x = new int[30000];",
            })
    void theMachinesErrorsHaveANumberAndNoMessage(String row) {
        String number = row.substring(0, row.indexOf(':'));
        String failing = row.substring(row.indexOf(':') + 1);
        assertThat(run(failing).screen()).isEqualTo(rows("Exception: " + number));
        SimulatedBrick brick =
                run(
                        "try {",
                        failing,
                        "} catch (Throwable e) {",
                        "LCD.drawString(e.getMessage() == null ? \"none\" : \"some\", 0, 0);",
                        "LCD.drawString(e.toString(), 0, 1);",
                        "LCD.drawString(\"+\" + e, 0, 2);",
                        "}");
        assertThat(brick.screen()).startsWith("none", "class " + number, "+class " + number);
    }

    @Test
    void whatTheProgramMakesItselfKeepsItsMessage() {
        SimulatedBrick brick =
                run(
                        "class Own extends RuntimeException {",
                        "  public String toString() { return \"own\"; } }",
                        "LCD.drawString(new ArithmeticException(\"a\").getMessage(), 0, 4);",
                        "LCD.drawString(new ArithmeticException(\"a\").toString(), 0, 1);",
                        "LCD.drawString(new RuntimeException(\"b\").toString(), 0, 2);",
                        "LCD.drawString(new Own().toString() + new Own(), 0, 3);",
                        "new IllegalStateException(\"c\").printStackTrace();");
        assertThat(brick.outcome().failure()).isEmpty();
        assertThat(brick.screen())
                .startsWith("class 31: c", "class 27: a", "class ?: b", "ownown", "a");
    }
}
