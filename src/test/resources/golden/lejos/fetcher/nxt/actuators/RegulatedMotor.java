package nxt.actuators;

import arcomat.nxt.Shaft;

/** Platform component nxt.RegulatedMotor on the brick. */
public final class RegulatedMotor {
    /** In degrees per second. */
    public int speed;

    public boolean hasSpeed;

    private final Shaft shaft;

    public RegulatedMotor(int socket) {
        shaft = new Shaft(socket);
    }

    /** Carries out the message of a slice. */
    public void act() {
        if (hasSpeed) {
            shaft.turn(speed);
        }
    }
}
