package parts.motors;

import parts.logic.LineStatus;

/** Two wheels that do as told, and keep to the line while they go forward. */
public final class Drive {
    public static final int GO_ON = 0;
    public static final int FORWARD = 1;
    public static final int STOP = 2;
    public static final int BACK_RIGHT = 3;

    /** In degrees per second: straight on, and the inner wheel in a bend. */
    private static final int CRUISE = 360;

    private static final int SLOW = 120;

    private final Wheel left;
    private final Wheel right;
    private boolean following;

    public Drive(Wheel left, Wheel right) {
        this.left = left;
        this.right = right;
    }

    public void step(int command, int drift) {
        switch (command) {
            case FORWARD:
                following = true;
                turn(CRUISE, CRUISE);
                break;
            case STOP:
                following = false;
                turn(0, 0);
                break;
            case BACK_RIGHT:
                following = false;
                turn(-CRUISE, -SLOW);
                break;
            default:
                if (following) {
                    follow(drift);
                }
                break;
        }
    }

    private void follow(int drift) {
        if (drift == LineStatus.DRIFT_LEFT) {
            turn(CRUISE, SLOW);
        } else if (drift == LineStatus.DRIFT_RIGHT) {
            turn(SLOW, CRUISE);
        } else {
            turn(CRUISE, CRUISE);
        }
    }

    private void turn(int leftSpeed, int rightSpeed) {
        left.turn(leftSpeed);
        right.turn(rightSpeed);
    }
}
