package lejos.nxt;

/** A socket that can feed a sensor of the older generation. */
public interface LegacySensorPort extends ADSensorPort {
    void activate();

    void passivate();
}
