package lejos.nxt;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.SensorSocket;
import arcomat.sim.time.VirtualTime;

import lejos.robotics.RangeFinder;

import java.util.Arrays;

/** The ultrasonic sensor: distances in cm, 255 for nothing in range. */
public class UltrasonicSensor extends I2CSensor implements RangeFinder {
    public static final byte MODE_OFF = 0;
    public static final byte MODE_PING = 1;
    public static final byte MODE_CONTINUOUS = 2;
    public static final byte MODE_CAPTURE = 3;
    public static final byte MODE_RESET = 4;

    private static final Hardware BRICK = Hardware.of(UltrasonicSensor.class);
    private static final int NO_ECHO = 255;
    private static final int ECHOES = 8;

    /** The sensor answers only so long after its last answer. */
    private static final long REST = 30 * VirtualTime.MILLISECOND;

    /** One question and its answer on the bus. */
    private static final long TRANSACTION = 5 * VirtualTime.MILLISECOND;

    private byte mode = MODE_CONTINUOUS;
    private long ready;

    public UltrasonicSensor(I2CPort port) {
        super(port);
    }

    public int getDistance() {
        awaitAnswer();
        return socket().observed(mode == MODE_OFF ? NO_ECHO : socket().distance());
    }

    /** Fills in what echoed, nearest first: here one thing at most. */
    public int getDistances(int[] distances) {
        return getDistances(distances, 0, Math.min(ECHOES, distances.length));
    }

    public int getDistances(int[] distances, int offset, int length) {
        Arrays.fill(distances, offset, offset + length, NO_ECHO);
        if (length > 0) {
            distances[offset] = getDistance();
        }
        return 0;
    }

    public float getRange() {
        return getDistance();
    }

    public float[] getRanges() {
        int distance = getDistance();
        return distance == NO_ECHO ? new float[0] : new float[] {distance};
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

    public int reset() {
        return setMode(MODE_RESET);
    }

    public int getMode() {
        return mode;
    }

    public int setMode(int mode) {
        awaitAnswer();
        this.mode = mode == MODE_RESET ? MODE_CONTINUOUS : (byte) mode;
        return 0;
    }

    private void awaitAnswer() {
        VirtualTime time = BRICK.time();
        time.waitUntil(Math.max(ready, time.now()) + TRANSACTION);
        ready = time.now() + REST - TRANSACTION;
    }

    /**
     * @throws IllegalStateException if the port is one of a multiplexer, which is not simulated
     */
    private SensorSocket socket() {
        if (port instanceof SensorPort own) {
            return own.socket();
        }
        throw new IllegalStateException("only SensorPort.S1 to S4 are simulated");
    }
}
