package lejos.nxt;

import arcomat.sim.bus.Sonar;
import arcomat.sim.device.Hardware;
import arcomat.sim.time.VirtualTime;

import lejos.robotics.RangeFinder;

/**
 * The ultrasonic sensor: distances in cm, 255 for nothing in range or no answer. It needs a rest
 * after each request, and time to listen. Unlike the brick's class, switching it on takes no time.
 */
public class UltrasonicSensor extends I2CSensor implements RangeFinder {
    public static final byte MODE_OFF = 0;
    public static final byte MODE_PING = 1;
    public static final byte MODE_CONTINUOUS = 2;
    public static final byte MODE_CAPTURE = 3;
    public static final byte MODE_RESET = 4;

    private static final Hardware BRICK = Hardware.of(UltrasonicSensor.class);
    private static final byte FACTORY_DATA = 0x11;
    private static final byte UNITS = 0x14;
    private static final byte INTERVAL = 0x40;
    private static final byte MODE = 0x41;
    private static final byte ECHOES = 0x42;
    private static final byte CALIBRATION = 0x4a;
    private static final int UNITS_LENGTH = 8;
    private static final int CALIBRATION_LENGTH = 3;
    private static final int NO_ECHO = 255;
    private static final int MOST_ECHOES = 8;

    /** Milliseconds between requests, and until an echo can be read. */
    private static final int REST = 5;

    private static final int LISTENING = 30;
    private static final int LISTENING_ONCE = 50;

    private final byte[] bytes = new byte[MOST_ECHOES];
    private byte mode = MODE_CONTINUOUS;
    private long nextRequest;
    private long nextEcho;

    public UltrasonicSensor(I2CPort port) {
        super(port, DEFAULT_I2C_ADDRESS, I2CPort.LEGO_MODE, TYPE_LOWSPEED_9V);
        if (port instanceof SensorPort own) {
            own.socket().bus().assume(new Sonar());
        }
    }

    @Override
    public int getData(int register, byte[] buf, int off, int len) {
        await(nextRequest);
        int result = super.getData(register, buf, off, len);
        nextRequest = BRICK.milliseconds() + REST;
        return result;
    }

    @Override
    public int sendData(int register, byte[] buf, int off, int len) {
        await(nextRequest);
        int result = super.sendData(register, buf, off, len);
        nextRequest = BRICK.milliseconds() + REST;
        return result;
    }

    public int getDistance() {
        int delay = listening();
        await(nextEcho);
        if (getData(ECHOES, bytes, 1) < 0) {
            return silence();
        }
        nextEcho = BRICK.milliseconds() + delay;
        return bytes[0] & 0xff;
    }

    private int silence() {
        return port instanceof SensorPort own ? own.socket().observed(NO_ECHO) : NO_ECHO;
    }

    /** Fills in what echoed, nearest first, and gives their number: here it is 0 or 1. */
    public int getDistances(int[] dist) {
        return getDistances(dist, 0, dist.length);
    }

    public int getDistances(int[] dist, int off, int len) {
        if (len < 0) {
            throw new IllegalArgumentException("len is negative");
        }
        if (len == 0) {
            return 0;
        }
        int delay = listening();
        int most = Math.min(len, mode == MODE_CAPTURE ? 1 : MOST_ECHOES);
        await(nextEcho);
        int result = getData(ECHOES, bytes, most);
        if (result < 0) {
            return result;
        }
        nextEcho = BRICK.milliseconds() + delay;
        int echoes = 0;
        while (echoes < most && (bytes[echoes] & 0xff) != NO_ECHO) {
            dist[off + echoes] = bytes[echoes] & 0xff;
            echoes++;
        }
        return echoes;
    }

    /**
     * @throws IllegalStateException if it does not listen
     */
    private int listening() {
        if (mode == MODE_OFF) {
            throw new IllegalStateException("sensor is off");
        }
        return mode == MODE_PING ? LISTENING_ONCE : LISTENING;
    }

    @Override
    public float getRange() {
        return getDistance();
    }

    /** As on the brick, this leaves the sensor where it listens no more by itself. */
    @Override
    public float[] getRanges() {
        ping();
        int[] distances = new int[MOST_ECHOES];
        int echoes = Math.max(0, getDistances(distances));
        float[] ranges = new float[echoes];
        for (int i = 0; i < echoes; i++) {
            ranges[i] = distances[i];
        }
        return ranges;
    }

    public int continuous() {
        return setMode(MODE_CONTINUOUS);
    }

    public int ping() {
        return setMode(MODE_PING);
    }

    public int capture() {
        return setMode(MODE_CAPTURE);
    }

    public int off() {
        return setMode(MODE_OFF);
    }

    /** Leaves it off. */
    public int reset() {
        return setMode(MODE_RESET);
    }

    /**
     * @throws IllegalArgumentException if there is no such mode
     */
    public int setMode(int mode) {
        if (mode < MODE_OFF || mode > MODE_RESET) {
            throw new IllegalArgumentException("unknown mode");
        }
        bytes[0] = (byte) mode;
        int result = sendData(MODE, bytes, 1);
        if (result == 0) {
            nextEcho = BRICK.milliseconds() + delayAfter(mode);
            this.mode = mode == MODE_RESET ? MODE_OFF : (byte) mode;
        }
        return result;
    }

    private static int delayAfter(int mode) {
        return switch (mode) {
            case MODE_RESET -> 0;
            case MODE_PING -> LISTENING_ONCE;
            default -> LISTENING;
        };
    }

    /** As this object has set it last. */
    public int getMode() {
        return mode;
    }

    /** As the sensor says. */
    public int getActualMode() {
        return read(MODE);
    }

    public int getContinuousInterval() {
        return read(INTERVAL);
    }

    private int read(byte register) {
        int result = getData(register, bytes, 1);
        return result < 0 ? result : bytes[0] & 0xff;
    }

    public int setContinuousInterval(int interval) {
        if (interval < 0 || interval > 0xff) {
            throw new IllegalArgumentException("value between 0 and 0xFF expected");
        }
        bytes[0] = (byte) interval;
        return sendData(INTERVAL, bytes, 1);
    }

    public String getUnits() {
        return fetchString(UNITS, UNITS_LENGTH);
    }

    public int getFactoryData(byte[] data) {
        return getEach(FACTORY_DATA, data);
    }

    public int getCalibrationData(byte[] data) {
        return getEach(CALIBRATION, data);
    }

    /** The sensor gives and takes these bytes one by one only. */
    private int getEach(byte register, byte[] data) {
        checkLength(data);
        for (int i = 0; i < CALIBRATION_LENGTH; i++) {
            int result = getData(register + i, bytes, 1);
            if (result < 0) {
                return result;
            }
            data[i] = bytes[0];
        }
        return 0;
    }

    public int setCalibrationData(byte[] data) {
        checkLength(data);
        for (int i = 0; i < CALIBRATION_LENGTH; i++) {
            bytes[0] = data[i];
            int result = sendData(CALIBRATION + i, bytes, 1);
            if (result < 0) {
                return result;
            }
        }
        return 0;
    }

    private static void checkLength(byte[] data) {
        if (data.length < CALIBRATION_LENGTH) {
            throw new IllegalArgumentException("array too small");
        }
    }

    private static void await(long milliseconds) {
        VirtualTime time = BRICK.time();
        time.waitUntil(Math.max(time.now(), milliseconds * VirtualTime.MILLISECOND));
    }
}
