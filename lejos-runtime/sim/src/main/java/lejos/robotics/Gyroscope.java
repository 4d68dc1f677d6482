package lejos.robotics;

/** A sensor that knows how fast it turns. */
public interface Gyroscope {
    /** In degrees per second. */
    float getAngularVelocity();

    void recalibrateOffset();
}
