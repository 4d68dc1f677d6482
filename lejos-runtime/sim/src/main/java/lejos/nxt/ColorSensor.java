package lejos.nxt;

import arcomat.sim.device.ColorEye;

import lejos.robotics.ColorDetector;
import lejos.robotics.LampLightDetector;

/**
 * The colour sensor. Of a surface with a colour it sees the parts that its lamp lights; of one that
 * is exposed as a percentage, its brightness.
 */
public class ColorSensor implements LampLightDetector, ColorDetector, SensorConstants {
    /** Names of colours by the sensor's own numbers. */
    protected static int[] colorMap = Colors.byNumber();

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
        port.enableColorSensor();
        setFloodlight(color);
    }

    protected void setType(int type) {
        this.type = type;
        port.setType(type);
    }

    /** The number of the colour as lejos.robotics.Color counts; -1 for none. */
    @Override
    public int getColorID() {
        return port.socket().observed(port.socket().eye().color());
    }

    @Override
    public Color getColor() {
        int color = getColorID();
        return color(color, ColorEye.FULL_PART, color);
    }

    /** Like {@link #getColor()}, as the converter sees it, and without a name. */
    public Color getRawColor() {
        return color(getColorID(), ColorEye.FULL_LEVEL, Color.NONE);
    }

    private static Color color(int seen, int full, int name) {
        return new Color(
                ColorEye.part(seen, ColorEye.RED) * full / ColorEye.FULL_PART,
                ColorEye.part(seen, ColorEye.GREEN) * full / ColorEye.FULL_PART,
                ColorEye.part(seen, ColorEye.BLUE) * full / ColorEye.FULL_PART,
                0,
                name);
    }

    @Override
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

    @Override
    public void setFloodlight(boolean floodlight) {
        setFloodlight(floodlight ? Color.RED : Color.NONE);
    }

    @Override
    public int getFloodlight() {
        return floodlight;
    }

    @Override
    public boolean isFloodlightOn() {
        return floodlight != Color.NONE;
    }

    /**
     * As on the brick, percent by the light of one lamp, but up to 255 where all three are used;
     * and calibrated ends change nothing.
     */
    @Override
    public int getLightValue() {
        int full = type == TYPE_COLORFULL ? ColorEye.FULL_PART : 100;
        return port.socket().observed(scaled(port.raw(), full));
    }

    private int scaled(int level, int full) {
        if (level >= 0) {
            return level * full / ColorEye.FULL_LEVEL;
        }
        return type == TYPE_COLORFULL ? 0 : level;
    }

    @Override
    public int getNormalizedLightValue() {
        return getRawLightValue();
    }

    public int getRawLightValue() {
        return port.socket().observed(scaled(port.raw(), ColorEye.FULL_LEVEL));
    }

    public void calibrateLow() {
        zero = port.raw();
    }

    public void calibrateHigh() {
        hundred = port.raw();
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
