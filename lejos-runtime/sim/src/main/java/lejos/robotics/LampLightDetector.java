package lejos.robotics;

/** Measures brightness and has a lamp of its own. */
public interface LampLightDetector extends LightDetector {
    void setFloodlight(boolean floodlight);

    boolean setFloodlight(int color);

    int getFloodlight();

    boolean isFloodlightOn();
}
