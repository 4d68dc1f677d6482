package lejos.robotics;

/** Counts degrees. */
public interface Encoder {
    int getTachoCount();

    void resetTachoCount();
}
