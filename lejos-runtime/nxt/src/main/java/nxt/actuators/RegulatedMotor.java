package nxt.actuators;

import arcomat.nxt.Wheel;

/** Platform component nxt.RegulatedMotor on the brick. */
public final class RegulatedMotor {
    /** In degrees per second. */
    public int speed;

    public boolean hasSpeed;

    private final Wheel wheel;

    public RegulatedMotor(int socket) {
        wheel = new Wheel(socket);
    }

    /** Carries out the message of a slice. */
    public void act() {
        if (hasSpeed) {
            wheel.turn(speed);
        }
    }
}
