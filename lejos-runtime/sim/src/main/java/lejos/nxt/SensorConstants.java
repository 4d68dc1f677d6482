package lejos.nxt;

/** Types and modes of sensors, and what the colour sensor's own numbers mean. */
public interface SensorConstants {
    int BLACK = 1;
    int BLANK_INDEX = 3;
    int BLUE = 2;
    int BLUE_INDEX = 2;
    int GREEN = 3;
    int GREEN_INDEX = 1;
    int MAX_AD_RAW = 1023;
    int MAX_TYPE = 17;
    int MIN_TYPE = 0;
    int MODE_ANGLESTEP = 224;
    int MODE_BOOLEAN = 32;
    int MODE_CELSIUS = 160;
    int MODE_FARENHEIT = 192;
    int MODE_PCTFULLSCALE = 128;
    int MODE_PERIODCOUNTER = 96;
    int MODE_RAW = 0;
    int MODE_TRANSITIONCNT = 64;
    int RED = 5;
    int RED_INDEX = 0;
    int TYPE_ANGLE = 4;
    int TYPE_COLORBLUE = 16;
    int TYPE_COLORFULL = 13;
    int TYPE_COLORGREEN = 15;
    int TYPE_COLORNONE = 17;
    int TYPE_COLORRED = 14;
    int TYPE_CUSTOM = 9;
    int TYPE_HISPEED = 12;
    int TYPE_LIGHT_ACTIVE = 5;
    int TYPE_LIGHT_INACTIVE = 6;
    int TYPE_LOWSPEED = 10;
    int TYPE_LOWSPEED_9V = 11;
    int TYPE_NO_SENSOR = 0;
    int TYPE_REFLECTION = 3;
    int TYPE_SOUND_DB = 7;
    int TYPE_SOUND_DBA = 8;
    int TYPE_SWITCH = 1;
    int TYPE_TEMPERATURE = 2;
    int WHITE = 6;
    int YELLOW = 4;
}
