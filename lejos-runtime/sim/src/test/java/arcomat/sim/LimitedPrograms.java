package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;
import arcomat.sim.load.Program;

/** Runs programs that meet a limit of the brick, or would without it. */
final class LimitedPrograms {
    private LimitedPrograms() {}

    static final String RESULT = "LCD.drawInt(%s, 0, 0);";

    static SimulatedBrick run(Limits limits, Program program) {
        try (Laboratory laboratory = new Laboratory(limits)) {
            SimulatedBrick brick = laboratory.place("brick", program);
            laboratory.runToEnd(600_000);
            return brick;
        }
    }

    static SimulatedBrick run(String... body) {
        return run(Limits.OF_THE_BRICK, Compiled.main(body));
    }

    /** What a program draws in the first row, the same in two runs. */
    static int number(Limits limits, String... body) {
        int number = Integer.parseInt(run(limits, Compiled.main(body)).screen().get(0));
        assertThat(run(limits, Compiled.main(body)).screen().get(0)).isEqualTo("" + number);
        return number;
    }

    static int number(String... body) {
        return number(Limits.OF_THE_BRICK, body);
    }
}
