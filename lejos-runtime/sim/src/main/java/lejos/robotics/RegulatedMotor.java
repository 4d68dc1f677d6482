package lejos.robotics;

/** A motor that keeps a speed in degrees per second and finds positions in degrees. */
public interface RegulatedMotor extends BaseMotor, Tachometer {
    void addListener(RegulatedMotorListener listener);

    RegulatedMotorListener removeListener();

    void stop(boolean immediateReturn);

    void flt(boolean immediateReturn);

    void waitComplete();

    void rotate(int angle, boolean immediateReturn);

    void rotate(int angle);

    void rotateTo(int limitAngle);

    void rotateTo(int limitAngle, boolean immediateReturn);

    int getLimitAngle();

    void setSpeed(int speed);

    int getSpeed();

    float getMaxSpeed();

    boolean isStalled();

    void setStallThreshold(int error, int time);

    void setAcceleration(int acceleration);
}
