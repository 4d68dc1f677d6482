package lean.logic;

import lean.motors.Drive;
import lean.sensors.DistanceSensor;

/** When two robots meet, the one with coffee waits and the other one makes room. */
public final class AvoidCrash {
    private static final int DRIVING = 0;
    private static final int BACKING = 1;
    private static final int WAITING = 2;
    private static final int REMOTE = 3;
    private static final int RETURNING = 4;

    /** How long it backs, in cycles. */
    private static final int BACKING_CYCLES = 3;

    private int state = DRIVING;
    private int command = Drive.FORWARD;
    private int cyclesLeft;

    /** What the wheels are to do from the next cycle on. */
    public int command() {
        return command;
    }

    public void decide(int range, boolean lineLost, boolean hasCoffee) {
        command = Drive.GO_ON;
        switch (state) {
            case DRIVING:
                if (range == DistanceSensor.TOO_CLOSE) {
                    meet(hasCoffee);
                }
                break;
            case BACKING:
                cyclesLeft--;
                if (cyclesLeft == 0) {
                    go(REMOTE, Drive.STOP);
                }
                break;
            case WAITING:
                if (range == DistanceSensor.CLEAR) {
                    go(DRIVING, Drive.FORWARD);
                }
                break;
            case REMOTE:
                if (range == DistanceSensor.CLEAR) {
                    go(RETURNING, Drive.FORWARD);
                }
                break;
            case RETURNING:
                if (!lineLost) {
                    state = DRIVING;
                }
                break;
            default:
                break;
        }
    }

    private void meet(boolean hasCoffee) {
        if (hasCoffee) {
            go(WAITING, Drive.STOP);
        } else {
            go(BACKING, Drive.BACK_RIGHT);
            cyclesLeft = BACKING_CYCLES;
        }
    }

    private void go(int nextState, int nextCommand) {
        state = nextState;
        command = nextCommand;
    }
}
