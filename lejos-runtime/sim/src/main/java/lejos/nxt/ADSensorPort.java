package lejos.nxt;

/** A socket for an analogue sensor. */
public interface ADSensorPort extends BasicSensorPort {
    boolean readBooleanValue();

    int readRawValue();

    int readValue();
}
