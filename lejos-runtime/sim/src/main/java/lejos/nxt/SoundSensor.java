package lejos.nxt;

/** The sound sensor: loudness from 0 to 100. */
public class SoundSensor implements SensorConstants {
    private final ADSensorPort port;

    public SoundSensor(ADSensorPort port) {
        this(port, false);
    }

    public SoundSensor(ADSensorPort port, boolean dba) {
        this.port = port;
        setDBA(dba);
    }

    public void setDBA(boolean dba) {
        port.setTypeAndMode(dba ? TYPE_SOUND_DBA : TYPE_SOUND_DB, MODE_PCTFULLSCALE);
    }

    public int readValue() {
        return port.readValue();
    }
}
