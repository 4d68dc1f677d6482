package nxt.actuators;

import arcomat.nxt.Shaft;

/** Platform component nxt.DifferentialDrive on the brick. */
public final class DifferentialDrive {
    /** In mm per second. */
    public int speed;

    public boolean hasSpeed;

    /** In degrees per second, to the left. */
    public int turn;

    public boolean hasTurn;

    private final Shaft left;
    private final Shaft right;

    /** Degrees of a wheel for one mm of way. */
    private final float degreesPerMillimetre;

    /** Degrees of the outer wheel for one degree of the robot, when it turns on the spot. */
    private final float degreesPerDegree;

    private int currentSpeed;
    private int currentTurn;

    public DifferentialDrive(int left, int right, int diameter, int track) {
        this.left = new Shaft(left);
        this.right = new Shaft(right);
        this.degreesPerMillimetre = 360f / ((float) Math.PI * diameter);
        this.degreesPerDegree = (float) track / diameter;
    }

    /** Carries out the messages of a slice. */
    public void act() {
        if (hasSpeed) {
            currentSpeed = speed;
        }
        if (hasTurn) {
            currentTurn = turn;
        }
        if (hasSpeed || hasTurn) {
            float forward = currentSpeed * degreesPerMillimetre;
            float outward = currentTurn * degreesPerDegree;
            left.turn(Math.round(forward - outward));
            right.turn(Math.round(forward + outward));
        }
    }
}
