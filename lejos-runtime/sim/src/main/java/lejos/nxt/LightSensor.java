package lejos.nxt;

import lejos.robotics.LampLightDetector;

/** The light sensor. Its percentage is not limited to the calibrated ends, just as on the brick. */
public class LightSensor implements LampLightDetector, SensorConstants {
    private static final int RED = 0;
    private static final int NONE = -1;

    private final ADSensorPort port;
    private int zero = MAX_AD_RAW;
    private int hundred;
    private boolean floodlight;

    public LightSensor(ADSensorPort port) {
        this(port, true);
    }

    public LightSensor(ADSensorPort port, boolean floodlight) {
        this.port = port;
        setFloodlight(floodlight);
    }

    @Override
    public void setFloodlight(boolean floodlight) {
        this.floodlight = floodlight;
        port.setTypeAndMode(
                floodlight ? TYPE_LIGHT_ACTIVE : TYPE_LIGHT_INACTIVE, MODE_PCTFULLSCALE);
    }

    @Override
    public boolean setFloodlight(int color) {
        if (color != RED && color != NONE) {
            return false;
        }
        setFloodlight(color == RED);
        return true;
    }

    @Override
    public int getFloodlight() {
        return floodlight ? RED : NONE;
    }

    @Override
    public boolean isFloodlightOn() {
        return floodlight;
    }

    @Override
    public int getLightValue() {
        int value = hundred == zero ? 0 : 100 * (raw() - zero) / (hundred - zero);
        return observed(value);
    }

    public int readValue() {
        return getLightValue();
    }

    @Override
    public int getNormalizedLightValue() {
        return observed(MAX_AD_RAW - raw());
    }

    public int readNormalizedValue() {
        return getNormalizedLightValue();
    }

    public void calibrateLow() {
        zero = port.readRawValue();
    }

    public void calibrateHigh() {
        hundred = port.readRawValue();
    }

    public void setLow(int low) {
        zero = MAX_AD_RAW - low;
    }

    public void setHigh(int high) {
        hundred = MAX_AD_RAW - high;
    }

    @Override
    public int getLow() {
        return MAX_AD_RAW - zero;
    }

    @Override
    public int getHigh() {
        return MAX_AD_RAW - hundred;
    }

    private int raw() {
        return port instanceof SensorPort own ? own.raw() : port.readRawValue();
    }

    /** Programs may implement ports of their own, which nobody watches. */
    private int observed(int value) {
        return port instanceof SensorPort own ? own.socket().observed(value) : value;
    }
}
