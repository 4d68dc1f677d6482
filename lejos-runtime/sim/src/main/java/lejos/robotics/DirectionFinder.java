package lejos.robotics;

/** A sensor that knows where it is turned. */
public interface DirectionFinder {
    /** Counter-clockwise from the direction that was made zero. */
    float getDegreesCartesian();

    void resetCartesianZero();

    void startCalibration();

    void stopCalibration();
}
