package lejos.nxt;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.SensorSocket;

/** The four sockets for sensors. */
public class SensorPort implements LegacySensorPort, I2CPort {
    public static final int NUMBER_OF_PORTS = 4;

    private static final Hardware BRICK = Hardware.of(SensorPort.class);
    private static final int RAW_PRESSED = 600;

    public static final SensorPort S1 = new SensorPort(0);
    public static final SensorPort S2 = new SensorPort(1);
    public static final SensorPort S3 = new SensorPort(2);
    public static final SensorPort S4 = new SensorPort(3);
    public static final SensorPort[] PORTS = {S1, S2, S3, S4};

    private final int id;
    private int type = TYPE_NO_SENSOR;
    private int mode = MODE_RAW;

    private SensorPort(int id) {
        this.id = id;
    }

    public static SensorPort getInstance(int id) {
        if (id < 0 || id >= NUMBER_OF_PORTS) {
            throw new IllegalArgumentException("no such sensor port");
        }
        return PORTS[id];
    }

    public final int getId() {
        return id;
    }

    /** What is plugged in; asking takes a little time. */
    SensorSocket socket() {
        return BRICK.called().socket(id);
    }

    public int getMode() {
        return mode;
    }

    public int getType() {
        return type;
    }

    public void setMode(int mode) {
        this.mode = mode;
    }

    public void setType(int type) {
        this.type = type;
    }

    public void setTypeAndMode(int type, int mode) {
        this.type = type;
        this.mode = mode;
    }

    public void reset() {
        setTypeAndMode(TYPE_NO_SENSOR, MODE_RAW);
    }

    public final void activate() {
        BRICK.called();
    }

    public final void passivate() {
        BRICK.called();
    }

    public void i2cEnable(int mode) {
        type = TYPE_LOWSPEED;
    }

    public void i2cDisable() {
        type = TYPE_NO_SENSOR;
    }

    public final boolean readBooleanValue() {
        int raw = raw();
        boolean pressed = raw < RAW_PRESSED;
        socket().observed(pressed ? 1 : 0);
        return pressed;
    }

    public final int readRawValue() {
        return socket().observed(raw());
    }

    public int readValue() {
        return socket().observed(value(raw()));
    }

    private int value(int raw) {
        return switch (mode) {
            case MODE_BOOLEAN -> raw < RAW_PRESSED ? 1 : 0;
            case MODE_PCTFULLSCALE -> (MAX_AD_RAW - raw) * 100 / MAX_AD_RAW;
            default -> raw;
        };
    }

    /** As the converter sees it; not reported, for sensors that make something else of it. */
    int raw() {
        SensorSocket socket = socket();
        return switch (type) {
            case TYPE_SWITCH -> socket.rawSwitch();
            case TYPE_LIGHT_ACTIVE,
                    TYPE_LIGHT_INACTIVE,
                    TYPE_REFLECTION,
                    TYPE_SOUND_DB,
                    TYPE_SOUND_DBA ->
                    socket.rawLevel();
            default -> socket.rawAny();
        };
    }
}
