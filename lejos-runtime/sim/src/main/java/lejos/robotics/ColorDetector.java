package lejos.robotics;

/** Sees colours. */
public interface ColorDetector {
    Color getColor();

    int getColorID();
}
