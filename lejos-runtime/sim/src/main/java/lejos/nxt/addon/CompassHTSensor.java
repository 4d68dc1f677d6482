package lejos.nxt.addon;

import arcomat.sim.bus.Compass;
import arcomat.sim.device.Hardware;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;
import lejos.nxt.SensorPort;
import lejos.robotics.DirectionFinder;

/** HiTechnic's compass. */
public class CompassHTSensor extends I2CSensor implements DirectionFinder {
    private static final Hardware BRICK = Hardware.of(CompassHTSensor.class);
    private static final int MODE = 0x41;
    private static final int HEADING = 0x42;
    private static final byte MEASURING = 0x00;
    private static final byte CALIBRATING = 0x43;
    private static final int FULL_TURN = 360;

    private final byte[] bytes = new byte[2];
    private float zero;

    public CompassHTSensor(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    public CompassHTSensor(I2CPort port, int address) {
        super(port, address, I2CPort.LEGO_MODE, TYPE_LOWSPEED);
        if (port instanceof SensorPort own) {
            BRICK.socket(own.getId()).bus().assume(new Compass());
        }
    }

    /** Clockwise from north; -1 where reading fails. */
    public float getDegrees() {
        if (getData(HEADING, bytes, bytes.length) != 0) {
            return -1;
        }
        return ((bytes[0] & 0xff) << 1) + bytes[1];
    }

    @Override
    public float getDegreesCartesian() {
        float degrees = zero - getDegrees();
        if (degrees >= FULL_TURN) {
            return degrees - FULL_TURN;
        }
        return degrees < 0 ? degrees + FULL_TURN : degrees;
    }

    @Override
    public void resetCartesianZero() {
        zero = getDegrees();
    }

    /** Nothing has to be calibrated here. */
    @Override
    public void startCalibration() {
        sendData(MODE, CALIBRATING);
    }

    @Override
    public void stopCalibration() {
        sendData(MODE, MEASURING);
    }
}
