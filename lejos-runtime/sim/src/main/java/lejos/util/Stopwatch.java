package lejos.util;

import arcomat.sim.device.Hardware;

/** Milliseconds since a moment. */
public class Stopwatch {
    private static final Hardware BRICK = Hardware.of(Stopwatch.class);

    private long start;

    public Stopwatch() {
        reset();
    }

    public void reset() {
        start = BRICK.milliseconds();
    }

    public int elapsed() {
        return (int) (BRICK.called().milliseconds() - start);
    }
}
