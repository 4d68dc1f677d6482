package lejos.nxt;

import arcomat.sim.bus.Thermometer;

import lejos.util.EndianTools;

/** LEGO's temperature sensor, which does not say who it is. */
public class TemperatureSensor extends I2CSensor {
    public static final int RESOLUTION_9BIT = 0;
    public static final int RESOLUTION_10BIT = 1;
    public static final int RESOLUTION_11BIT = 2;
    public static final int RESOLUTION_12BIT = 3;
    protected static final int I2C_ADDRESS = 0x98;
    protected static final int REG_TEMPERATURE = 0;
    protected static final int REG_CONFIG = 1;
    protected static final int REG_TLOW = 2;
    protected static final int REG_THIGH = 3;

    private static final int RESOLUTION_PLACE = 5;
    private static final float PARTS_OF_A_DEGREE = 256;

    private final byte[] bytes = new byte[2];

    public TemperatureSensor(I2CPort port) {
        super(port, I2C_ADDRESS, I2CPort.LEGO_MODE, TYPE_LOWSPEED);
        if (port instanceof SensorPort own) {
            own.socket().bus().assume(new Thermometer());
        }
    }

    /** Milliseconds that a measurement takes. */
    public static int getSamplingDelay(int resolution) {
        return switch (resolution) {
            case RESOLUTION_9BIT -> 28;
            case RESOLUTION_10BIT -> 55;
            case RESOLUTION_11BIT -> 110;
            case RESOLUTION_12BIT -> 220;
            default -> throw new IllegalArgumentException();
        };
    }

    /** In degrees Celsius; as on the brick, the last one where reading fails. */
    public float getTemperature() {
        getData(REG_TEMPERATURE, bytes, 2);
        return EndianTools.decodeShortBE(bytes, 0) / PARTS_OF_A_DEGREE;
    }

    public int getResolution() {
        getData(REG_CONFIG, bytes, 1);
        return bytes[0] >>> RESOLUTION_PLACE & RESOLUTION_12BIT;
    }

    public void setResolution(int resolution) {
        if (resolution < RESOLUTION_9BIT || resolution > RESOLUTION_12BIT) {
            throw new IllegalArgumentException();
        }
        sendData(REG_CONFIG, (byte) (resolution << RESOLUTION_PLACE));
    }

    /** The sensor has no text to read; on the brick, too, this is what whoever asks gets. */
    @Override
    public String getVendorID() {
        throw new UnsupportedOperationException();
    }

    /** As {@link #getVendorID}. */
    @Override
    public String getProductID() {
        throw new UnsupportedOperationException();
    }

    /** As {@link #getVendorID}. */
    @Override
    public String getVersion() {
        throw new UnsupportedOperationException();
    }
}
