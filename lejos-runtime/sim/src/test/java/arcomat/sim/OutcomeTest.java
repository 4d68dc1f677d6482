package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.sim.device.Key;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.MotorOrder;
import arcomat.sim.device.Screen;
import arcomat.sim.device.SilentObserver;
import arcomat.sim.load.Program;
import arcomat.sim.script.ScriptParser;
import arcomat.sim.time.OutOfPatience;

import org.junit.jupiter.api.Test;

import java.time.Duration;
import java.util.List;
import java.util.Map;

/** How programs end, and what is left of them. */
class OutcomeTest {
    private static final String OBSERVER =
            "an observer of the program failed: java.lang.IllegalStateException: ";

    private static SimulatedBrick run(Program program, String script) {
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("brick", program);
            brick.play(ScriptParser.parse(script).script().orElseThrow());
            laboratory.runToEnd(10_000);
            return brick;
        }
    }

    @Test
    void anUncaughtErrorIsReportedWithItsPlace() {
        SimulatedBrick brick =
                run(Compiled.main("int zero = args == null ? 0 : 1;", "int x = 1 / zero;"), "");
        assertThat(brick.outcome().kind()).isEqualTo(Outcome.Kind.FAILED);
        assertThat(brick.outcome().failure())
                .contains("java.lang.ArithmeticException: / by zero at Main.main (Main.java:7)");
    }

    @Test
    void anErrorOfAnotherThreadEndsTheProgramToo() {
        SimulatedBrick brick =
                run(
                        Compiled.main(
                                "new Thread() { public void run() {",
                                "throw new IllegalStateException(\"oops\"); } }.start();",
                                "while (true) { }"),
                        "");
        assertThat(brick.outcome().failure().orElseThrow()).contains("oops");
    }

    @Test
    void anEmptyLoopIsEndedByTheScript() {
        assertThat(run(Compiled.main("while (true) { }"), "500 end").outcome().kind())
                .isEqualTo(Outcome.Kind.STOPPED);
    }

    @Test
    void aProgramThatSwallowsEverythingIsLeftBehind() {
        Program program =
                Compiled.main(
                        "while (true) { try { Delay.msDelay(10); } catch (Throwable e) { } }");
        assertThat(run(program, "500 end").outcome().kind()).isEqualTo(Outcome.Kind.STOPPED);
    }

    @Test
    void bothButtonsTogetherAbort() {
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick =
                    laboratory.place("brick", Compiled.main("Motor.C.forward();", "for (;;) { }"));
            laboratory.runUntil(100);
            brick.press(Key.ENTER);
            laboratory.runUntil(200);
            assertThat(brick.isRunning()).isTrue();
            brick.press(Key.ESCAPE);
            laboratory.runToEnd(10_000);
            assertThat(laboratory.time()).isEqualTo(250);
            assertThat(brick.outcome().kind()).isEqualTo(Outcome.Kind.ABORTED);
        }
    }

    /** Braked or not: on the brick, too, the motors are let go when the program is over. */
    @Test
    void motorsAreLetGoAtTheEnd() {
        for (String end : List.of("", "int x = 1 / (args == null ? 0 : 1);", "System.exit(0);")) {
            try (Laboratory laboratory = new Laboratory()) {
                String[] body = {
                    "Motor.A.setSpeed(600);",
                    "Motor.A.forward();",
                    "Delay.msDelay(500);",
                    "Motor.A.stop(true);",
                    end
                };
                SimulatedBrick brick = laboratory.place("brick", Compiled.main(body));
                laboratory.runToEnd(10_000);
                assertThat(brick.motor(MotorName.A).order()).isEqualTo(MotorOrder.FLOAT);
                assertThat(brick.motor(MotorName.A).speed()).isGreaterThan(500);
                laboratory.runUntil(laboratory.time() + 1000);
                assertThat(brick.motor(MotorName.A).speed()).isZero();
            }
        }
    }

    @Test
    void whatAProgramDoesAfterItsEndHasNoEffect() {
        SimulatedBrick brick =
                run(
                        Compiled.main(
                                "try { Delay.msDelay(9000); }",
                                "finally { LCD.drawString(\"late\", 0, 0); }"),
                        "100 end");
        assertThat(brick.screen().get(0)).isEmpty();
    }

    /** It holds what the other thread needs to be loaded, and sleeps for ever: nobody goes on. */
    @Test
    void whatStandsStillIsGivenUp() {
        Program program =
                Compiled.source(
                        "Locked",
                        """
                        public class Locked {
                            static class Slow {
                                static int value = sleep();
                                static int sleep() {
                                    lejos.util.Delay.msDelay(100000000);
                                    return 1;
                                }
                            }
                            public static void main(String[] args) {
                                new Thread() {
                                    public void run() {
                                        System.out.println(Slow.value);
                                    }
                                }.start();
                                System.out.println(Slow.value);
                            }
                        }
                        """);
        try (Laboratory laboratory = new Laboratory()) {
            laboratory.place("brick", program);
            laboratory.limit(Duration.ofMillis(300));
            assertThatThrownBy(() -> laboratory.runToEnd(1000)).isInstanceOf(OutOfPatience.class);
        }
    }

    @Test
    void whatIsMissingIsNamed() {
        Program complete =
                Compiled.source(
                        "Main",
                        """
                        public class Main {
                            public static void main(String[] args) {
                                new Part();
                            }
                        }
                        class Part {}
                        """);
        Program program = new Program("Main", Map.of("Main", complete.classes().get("Main")));
        assertThat(run(program, "").outcome().failure().orElseThrow())
                .contains("Part is not in the program's jar")
                .contains("Main.java:3");
    }

    /** Neither the program nor the world may catch what an observer throws. */
    @Test
    void anObserverThatThrowsEndsTheProgramWithAMessage() {
        String swallows =
                "while (true) { try { LCD.drawInt(1, 0, 0); Delay.msDelay(10); }"
                        + " catch (RuntimeException e) { } }";
        assertThat(observed(swallows)).startsWith(OBSERVER + "the screen");
        assertThat(observed("Motor.A.forward();", "Delay.msDelay(1000);"))
                .startsWith(OBSERVER + "the motor is let go");
        assertThat(observed("Motor.A.forward();", "while (true) { Delay.msDelay(10); }"))
                .startsWith(OBSERVER + "the motor is let go");
        assertThat(observed("int x = 1 / (args == null ? 0 : 1);")).contains("/ by zero");
    }

    private static String observed(String... body) {
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("brick", Compiled.main(body));
            brick.observe(new Disturbed());
            laboratory.runUntil(2000);
            brick.press(Key.ENTER);
            brick.press(Key.ESCAPE);
            laboratory.runToEnd(10_000);
            assertThat(brick.outcome().kind()).isEqualTo(Outcome.Kind.FAILED);
            return brick.outcome().failure().orElseThrow();
        }
    }

    private static final class Disturbed extends SilentObserver {
        @Override
        public void screenChanged(long time, Screen screen) {
            throw new IllegalStateException("the screen");
        }

        @Override
        public void motorOrdered(long time, int motor, MotorOrder order, int value) {
            if (order == MotorOrder.FLOAT) {
                throw new IllegalStateException("the motor is let go");
            }
        }
    }

    @Test
    void theMainClassNeedNotBePublic() {
        Program program =
                Compiled.source("Quiet", "class Quiet { public static void main(String[] a) {} }");
        assertThat(run(program, "").outcome().kind()).isEqualTo(Outcome.Kind.ENDED);
    }

    @Test
    void aProgramWithoutMainSaysSo() {
        Program program = Compiled.source("Empty", "public class Empty {}");
        assertThat(run(program, "").outcome().failure().orElseThrow())
                .contains("Empty has no method public static void main(String[])");
    }

    @Test
    void aSecondStartOfAThreadIsAnError() {
        Program program =
                Compiled.main(
                        "Thread thread = new Thread();", "thread.start();", "thread.start();");
        assertThat(run(program, "").outcome().failure().orElseThrow())
                .contains("a thread is started only once");
    }

    @Test
    void aTimerOfThePcIsRefused() {
        assertThat(
                        run(Compiled.main("new java.util.Timer();"), "")
                                .outcome()
                                .failure()
                                .orElseThrow())
                .contains("java.util.Timer is not simulated");
    }

    @Test
    void simulatedClassesRefuseToWorkOutsideABrick() {
        assertThatThrownBy(() -> Class.forName("lejos.nxt.Motor"))
                .isInstanceOf(ExceptionInInitializerError.class)
                .rootCause()
                .hasMessageContaining("works inside a simulated brick only");
    }
}
