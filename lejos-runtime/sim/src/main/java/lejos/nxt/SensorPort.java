package lejos.nxt;

import arcomat.sim.device.ColorEye;
import arcomat.sim.device.Hardware;
import arcomat.sim.device.I2CBus;
import arcomat.sim.device.SensorSocket;
import arcomat.sim.time.VirtualTime;

/** The four sockets for sensors. */
public class SensorPort implements LegacySensorPort, I2CPort, ListenerCaller {
    public static final int NUMBER_OF_PORTS = 4;
    public static final int POWER_STD = 0;
    public static final int POWER_RCX9V = 1;
    public static final int POWER_9V = 2;
    public static final int SP_DIGI0 = 0;
    public static final int SP_DIGI1 = 1;
    public static final int SP_ANA = 2;
    public static final int SP_MODE_OFF = 0;
    public static final int SP_MODE_INPUT = 1;
    public static final int SP_MODE_OUTPUT = 2;
    public static final int SP_MODE_ADC = 3;

    private static final Hardware BRICK = Hardware.of(SensorPort.class);
    private static final int RAW_PRESSED = 600;
    private static final int FAILED = -1;
    private static final int PERCENT = 100;

    /** Milliseconds to wait for a bus that is not free, before a request fails. */
    private static final int PATIENCE = 10;

    public static final SensorPort S1 = new SensorPort(0);
    public static final SensorPort S2 = new SensorPort(1);
    public static final SensorPort S3 = new SensorPort(2);
    public static final SensorPort S4 = new SensorPort(3);
    public static final SensorPort[] PORTS = {S1, S2, S3, S4};

    private final int id;
    private int type = TYPE_NO_SENSOR;
    private int mode = MODE_RAW;
    private boolean knowsColors;
    private PortListeners listeners;

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

    private I2CBus bus() {
        return socket().bus();
    }

    @Override
    public int getMode() {
        return mode;
    }

    @Override
    public int getType() {
        return type;
    }

    @Override
    public void setMode(int mode) {
        this.mode = mode;
    }

    @Override
    public void setType(int newType) {
        if (newType < MIN_TYPE || newType > MAX_TYPE) {
            throw new IllegalArgumentException();
        }
        type = newType;
    }

    @Override
    public void setTypeAndMode(int type, int mode) {
        setType(type);
        setMode(mode);
    }

    public void reset() {
        setTypeAndMode(TYPE_NO_SENSOR, MODE_RAW);
    }

    /** Without it the types of the colour sensor give nothing. */
    public void enableColorSensor() {
        if (!knowsColors) {
            knowsColors = true;
            reset();
        }
    }

    /** Simulated sensors need no power. */
    public void setPowerType(int type) {
        BRICK.called();
    }

    @Override
    public final void activate() {
        setPowerType(POWER_RCX9V);
    }

    @Override
    public final void passivate() {
        setPowerType(POWER_STD);
    }

    @Override
    public final boolean readBooleanValue() {
        int raw = raw();
        boolean pressed = raw < RAW_PRESSED;
        socket().observed(pressed ? 1 : 0);
        return pressed;
    }

    @Override
    public final int readRawValue() {
        return socket().observed(raw());
    }

    @Override
    public int readValue() {
        return socket().observed(isColorSensor() ? colorValue() : value(raw()));
    }

    private int value(int raw) {
        if (raw == FAILED) {
            return FAILED;
        }
        return switch (mode) {
            case MODE_BOOLEAN -> raw < RAW_PRESSED ? 1 : 0;
            case MODE_PCTFULLSCALE -> (MAX_AD_RAW - raw) * PERCENT / MAX_AD_RAW;
            default -> raw;
        };
    }

    /** What the colour sensor makes of the colour's parts, or else percent. */
    private int colorValue() {
        if (!knowsColors) {
            return FAILED;
        }
        if (type == TYPE_COLORFULL) {
            return Colors.ofSensor(socket().eye().color());
        }
        int level = raw();
        return level < 0 ? FAILED : level * PERCENT / MAX_AD_RAW;
    }

    /** Red, green, blue and what comes from the surroundings, up to 255; only of colours. */
    public int readValues(int[] values) {
        return parts(values, ColorEye.FULL_PART);
    }

    /** As the converter sees them, up to 1023. */
    public int readRawValues(int[] values) {
        return parts(values, ColorEye.FULL_LEVEL);
    }

    private int parts(int[] values, int full) {
        SensorSocket socket = socket();
        if (type != TYPE_COLORFULL || !knowsColors || !socket.isExposed()) {
            return FAILED;
        }
        for (int lamp = RED_INDEX; lamp <= BLANK_INDEX; lamp++) {
            values[lamp] = socket.eye().level(lamp) * full / MAX_AD_RAW;
        }
        socket.observed(socket.eye().level(ColorEye.ALL) * full / MAX_AD_RAW);
        return BLANK_INDEX + 1;
    }

    private boolean isColorSensor() {
        return type >= TYPE_COLORFULL;
    }

    /** As the converter sees it; not reported, for sensors that make something else of it. */
    int raw() {
        SensorSocket socket = socket();
        return switch (type) {
            case TYPE_NO_SENSOR -> FAILED;
            case TYPE_SWITCH -> socket.rawSwitch();
            case TYPE_LIGHT_ACTIVE,
                    TYPE_LIGHT_INACTIVE,
                    TYPE_REFLECTION,
                    TYPE_SOUND_DB,
                    TYPE_SOUND_DBA ->
                    socket.rawLevel();
            case TYPE_COLORFULL, TYPE_COLORRED, TYPE_COLORGREEN, TYPE_COLORBLUE, TYPE_COLORNONE ->
                    knowsColors ? socket.eye().level(Colors.lamp(type)) : FAILED;
            default -> socket.rawAny();
        };
    }

    /** As the converter sees it, whatever the type is. */
    int converted() {
        return type == TYPE_NO_SENSOR ? socket().rawAny() : raw();
    }

    /** As on the brick, there is room for eight. */
    public void addSensorPortListener(SensorPortListener aListener) {
        listeners().add(aListener);
    }

    /** How much a raw value has to change before listeners are told. */
    public void setListenerTolerance(int tolerance) {
        listeners().setTolerance(tolerance);
    }

    @Override
    public int callListeners() {
        return listeners().callListeners();
    }

    private PortListeners listeners() {
        if (listeners == null) {
            listeners = new PortListeners(this);
        }
        return listeners;
    }

    @Override
    public void i2cEnable(int mode) {
        bus().enable((mode & HIGH_SPEED) != 0);
    }

    @Override
    public void i2cDisable() {
        bus().disable();
    }

    @Override
    public int i2cStatus() {
        return bus().status();
    }

    /** Begins a request and does not wait: negative where it cannot begin. */
    public int i2cStart(
            int address, byte[] writeBuffer, int writeOffset, int writeLen, int readLen) {
        return bus().start(address, writeBuffer, writeOffset, writeLen, readLen);
    }

    public void i2cWaitIOComplete() {
        VirtualTime time = BRICK.time();
        time.waitUntil(Math.max(time.now(), bus().due()));
    }

    /** The number of bytes that have come, or what went wrong. */
    public int i2cComplete(byte[] buffer, int offset, int numBytes) {
        return bus().complete(buffer, offset, numBytes);
    }

    @Override
    public int i2cTransaction(
            int deviceAddress,
            byte[] writeBuf,
            int writeOffset,
            int writeLen,
            byte[] readBuf,
            int readOffset,
            int readLen) {
        I2CBus bus = bus();
        int begun = bus.start(deviceAddress, writeBuf, writeOffset, writeLen, readLen);
        if (begun == ERR_BUS_BUSY) {
            BRICK.time().waitUntil(BRICK.tickAfter(PATIENCE));
            begun = bus.start(deviceAddress, writeBuf, writeOffset, writeLen, readLen);
        }
        if (begun < 0) {
            return begun;
        }
        BRICK.time().waitUntil(bus.due());
        return bus.complete(readBuf, readOffset, readLen);
    }
}
