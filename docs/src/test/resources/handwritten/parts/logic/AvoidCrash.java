package parts.logic;

import parts.motors.Drive;

/** When two robots meet, the one with coffee waits and the other one makes room. */
public final class AvoidCrash {
    private static final int DRIVING = 0;
    private static final int BACKING = 1;
    private static final int WAITING = 2;
    private static final int REMOTE = 3;
    private static final int RETURNING = 4;

    private int state = DRIVING;
    private int command = Drive.FORWARD;
    private boolean startsTimer;

    /** What the wheels are to do from the next slice on. */
    public int command() {
        return command;
    }

    /** Whether it wants to be told when it has backed far enough. */
    public boolean startsTimer() {
        return startsTimer;
    }

    public void step(int front, boolean alert, boolean lineLost, boolean hasCoffee) {
        command = Drive.GO_ON;
        startsTimer = false;
        switch (state) {
            case DRIVING:
                if (front == Proximity.TOO_CLOSE) {
                    meet(hasCoffee);
                }
                break;
            case BACKING:
                if (alert) {
                    go(REMOTE, Drive.STOP);
                }
                break;
            case WAITING:
                if (front == Proximity.CLEAR) {
                    go(DRIVING, Drive.FORWARD);
                }
                break;
            case REMOTE:
                if (front == Proximity.CLEAR) {
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
            startsTimer = true;
        }
    }

    private void go(int nextState, int nextCommand) {
        state = nextState;
        command = nextCommand;
    }
}
