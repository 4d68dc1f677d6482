package lejos.robotics;

/** A motor without regulation: power in percent. */
public interface DCMotor extends BaseMotor {
    void setPower(int power);

    int getPower();
}
