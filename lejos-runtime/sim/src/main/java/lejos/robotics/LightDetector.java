package lejos.robotics;

/** Measures brightness. */
public interface LightDetector {
    int getLightValue();

    int getNormalizedLightValue();

    int getHigh();

    int getLow();
}
