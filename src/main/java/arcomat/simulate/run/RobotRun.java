package arcomat.simulate.run;

import arcomat.model.Trace;

import java.util.List;

/**
 * What the program of a robot did, as a run of its model.
 *
 * @param times at which its steps began, in milliseconds
 */
public record RobotRun(String robot, Trace trace, List<Long> times) {
    public RobotRun {
        times = List.copyOf(times);
    }
}
