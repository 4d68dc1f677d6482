package lejos.robotics;

/** Measures distances in cm. */
public interface RangeFinder {
    float getRange();

    float[] getRanges();
}
