package arcomat.sim.device;

/**
 * Where a shaft is at any moment: at most three stretches of constant acceleration, then rest or
 * constant speed. Closed formulas instead of small steps: nothing has to run while time passes.
 * Positions in degrees, speeds in degrees per second, times in microseconds.
 */
final class Trajectory {
    private static final double SECOND = 1e6;

    private final double[] start = new double[4];
    private final double[] position = new double[4];
    private final double[] speed = new double[4];
    private final double[] acceleration = new double[4];
    private int stretches = 1;

    double position(long now) {
        int stretch = stretchAt(now);
        double elapsed = (now - start[stretch]) / SECOND;
        return position[stretch]
                + speed[stretch] * elapsed
                + acceleration[stretch] * elapsed * elapsed / 2;
    }

    double speed(long now) {
        int stretch = stretchAt(now);
        return speed[stretch] + acceleration[stretch] * (now - start[stretch]) / SECOND;
    }

    /** When the last stretch, of constant speed, begins. */
    long settled() {
        return (long) Math.ceil(start[stretches - 1]);
    }

    /** Reaches a speed and keeps it; 0 means to stop. */
    void reach(long now, double target, double rate) {
        begin(now);
        changeSpeed(target, rate);
        rest(target);
    }

    /** Goes to a position and stops there, never faster than a limit. */
    void goTo(long now, double target, double limit, double rate) {
        begin(now);
        double initial = speed[0];
        double way = target - position[0];
        double stopping = initial * Math.abs(initial) / (2 * rate);
        double direction = way >= stopping ? 1 : -1;
        // Up to the peak and down to 0: way = (peak^2 - initial^2 + peak^2) / (2 rate), seen
        // forwards.
        double peak = Math.sqrt(Math.max(0, rate * direction * way + initial * initial / 2));
        double top = direction * Math.min(peak, limit);
        changeSpeed(top, rate);
        if (peak > limit) {
            double braking = top * Math.abs(top) / (2 * rate);
            keepSpeed(target - braking - position[stretches - 1]);
        }
        changeSpeed(0, rate);
        position[stretches - 1] = target; // exactly, whatever rounding did
        rest(0);
    }

    private void begin(long now) {
        double at = position(now);
        double initial = speed(now);
        stretches = 1;
        start[0] = now;
        position[0] = at;
        speed[0] = initial;
    }

    private void changeSpeed(double target, double rate) {
        int last = stretches - 1;
        double change = target - speed[last];
        if (change == 0) {
            return;
        }
        acceleration[last] = Math.signum(change) * rate;
        double seconds = change / acceleration[last];
        append(seconds, (speed[last] + target) / 2 * seconds, target);
    }

    private void keepSpeed(double way) {
        int last = stretches - 1;
        if (speed[last] == 0) {
            return;
        }
        acceleration[last] = 0;
        append(Math.max(0, way / speed[last]), way, speed[last]);
    }

    private void append(double seconds, double way, double endSpeed) {
        start[stretches] = start[stretches - 1] + seconds * SECOND;
        position[stretches] = position[stretches - 1] + way;
        speed[stretches] = endSpeed;
        stretches++;
    }

    private void rest(double finalSpeed) {
        speed[stretches - 1] = finalSpeed;
        acceleration[stretches - 1] = 0;
    }

    private int stretchAt(long now) {
        int stretch = stretches - 1;
        while (stretch > 0 && start[stretch] > now) {
            stretch--;
        }
        return stretch;
    }
}
