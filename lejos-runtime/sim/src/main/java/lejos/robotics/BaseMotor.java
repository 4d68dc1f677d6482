package lejos.robotics;

/** A motor that turns or does not. */
public interface BaseMotor {
    void forward();

    void backward();

    void stop();

    void flt();

    boolean isMoving();
}
