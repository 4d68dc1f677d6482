package lejos.nxt;

import lejos.robotics.ColorDetector;
import lejos.robotics.LampLightDetector;

/** The colour sensor. The simulated one knows names of colours, not their parts. */
public class ColorSensor implements LampLightDetector, ColorDetector, SensorConstants {
    protected SensorPort port;
    protected int type;

    private int floodlight = Color.WHITE;
    private int zero = MAX_AD_RAW;
    private int hundred;

    public ColorSensor(SensorPort port) {
        this(port, Color.WHITE);
    }

    public ColorSensor(SensorPort port, int color) {
        this.port = port;
        setFloodlight(color);
    }

    protected void setType(int type) {
        this.type = type;
        port.setTypeAndMode(type, MODE_RAW);
    }

    /** The number of the colour as lejos.robotics.Color counts; -1 for none. */
    public int getColorID() {
        return port.socket().observed(port.socket().color());
    }

    public Color getColor() {
        int color = getColorID();
        boolean white = color == Color.WHITE;
        int full = 255;
        return new Color(
                white || color == Color.RED || color == Color.YELLOW ? full : 0,
                white || color == Color.GREEN || color == Color.YELLOW ? full : 0,
                white || color == Color.BLUE ? full : 0,
                0,
                color);
    }

    public boolean setFloodlight(int color) {
        int newType =
                switch (color) {
                    case Color.RED -> TYPE_COLORRED;
                    case Color.GREEN -> TYPE_COLORGREEN;
                    case Color.BLUE -> TYPE_COLORBLUE;
                    case Color.WHITE -> TYPE_COLORFULL;
                    case Color.NONE -> TYPE_COLORNONE;
                    default -> TYPE_NO_SENSOR;
                };
        if (newType == TYPE_NO_SENSOR) {
            return false;
        }
        floodlight = color;
        setType(newType);
        return true;
    }

    public void setFloodlight(boolean floodlight) {
        setFloodlight(floodlight ? Color.RED : Color.NONE);
    }

    public int getFloodlight() {
        return floodlight;
    }

    public boolean isFloodlightOn() {
        return floodlight != Color.NONE;
    }

    public int getLightValue() {
        int raw = port.socket().rawLevel();
        int value = hundred == zero ? 0 : 100 * (raw - zero) / (hundred - zero);
        return port.socket().observed(value);
    }

    public int getNormalizedLightValue() {
        return port.socket().observed(MAX_AD_RAW - port.socket().rawLevel());
    }

    public int getRawLightValue() {
        return getNormalizedLightValue();
    }

    public void calibrateLow() {
        zero = port.socket().rawLevel();
    }

    public void calibrateHigh() {
        hundred = port.socket().rawLevel();
    }

    public void setLow(int low) {
        zero = MAX_AD_RAW - low;
    }

    public void setHigh(int high) {
        hundred = MAX_AD_RAW - high;
    }

    public int getLow() {
        return MAX_AD_RAW - zero;
    }

    public int getHigh() {
        return MAX_AD_RAW - hundred;
    }

    /** A colour with the brightness of the surroundings. */
    public static class Color extends lejos.robotics.Color {
        private final int background;

        public Color(int red, int green, int blue, int background, int color) {
            super(red, green, blue, color);
            this.background = background;
        }

        public int getBackground() {
            return background;
        }
    }
}
