package lean.sensors;

import lejos.nxt.LightSensor;
import lejos.nxt.SensorPort;

/** Looks down with two light sensors. The line is dark and as wide as they are apart. */
public final class LineSensor {
    public static final int NO_DRIFT = 0;
    public static final int DRIFT_LEFT = 1;
    public static final int DRIFT_RIGHT = 2;

    /** The line is darker than this, in percent. */
    private static final int DARK = 45;

    private final LightSensor left;
    private final LightSensor right;
    private boolean leftSees;
    private boolean rightSees;

    public LineSensor(SensorPort leftPort, SensorPort rightPort) {
        left = new LightSensor(leftPort);
        right = new LightSensor(rightPort);
    }

    public void look() {
        leftSees = left.getLightValue() < DARK;
        rightSees = right.getLightValue() < DARK;
    }

    public boolean isLost() {
        return !leftSees && !rightSees;
    }

    public int drift() {
        if (leftSees == rightSees) {
            return NO_DRIFT;
        }
        return leftSees ? DRIFT_RIGHT : DRIFT_LEFT;
    }
}
