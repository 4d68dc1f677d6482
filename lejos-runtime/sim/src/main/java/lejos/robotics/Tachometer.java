package lejos.robotics;

/** Counts degrees and knows the speed, in degrees per second. */
public interface Tachometer extends Encoder {
    int getRotationSpeed();
}
