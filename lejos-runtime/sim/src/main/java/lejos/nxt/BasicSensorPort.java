package lejos.nxt;

/** A socket for a sensor of a type, read in a mode. */
public interface BasicSensorPort extends SensorConstants {
    int getMode();

    int getType();

    void setMode(int mode);

    void setType(int type);

    void setTypeAndMode(int type, int mode);
}
