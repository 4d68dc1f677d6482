package arcomat.sim.bus;

import java.util.Arrays;

/**
 * LEGO's ultrasonic sensor. It measures all the time, or once when it is told to, and keeps what it
 * heard last. In front of a simulated one there is one thing at most, so at most one echo.
 */
public final class Sonar implements I2CDevice {
    private static final int VERSION = 0x00;
    private static final int VENDOR = 0x08;
    private static final int PRODUCT = 0x10;
    private static final int FACTORY_DATA = 0x11;
    private static final int UNITS = 0x14;
    private static final int INTERVAL = 0x40;
    private static final int MODE = 0x41;
    private static final int ECHOES = 0x42;
    private static final int CALIBRATION = 0x4a;

    private static final int OFF = 0;
    private static final int ONCE = 1;
    private static final int CONTINUOUS = 2;
    private static final int RESET = 4;

    private static final int NO_ECHO = 255;

    /** Zero, factor and divisor of the scale. */
    private static final int[] SCALE = {0, 1, 14};

    private int mode = CONTINUOUS;
    private int interval = 1;
    private int heard = NO_ECHO;

    @Override
    public void read(int register, byte[] answer, Surroundings around) {
        switch (register) {
            case VERSION -> Registers.text("V1.0", answer);
            case VENDOR -> Registers.text("LEGO", answer);
            case PRODUCT -> Registers.text("Sonar", answer);
            case UNITS -> Registers.text("10E-2m", answer);
            case INTERVAL -> Registers.number(interval, answer);
            case MODE -> Registers.number(mode, answer);
            default -> Registers.number(scale(register), answer);
        }
        if (register == ECHOES) {
            Arrays.fill(answer, (byte) NO_ECHO);
            listen(mode == CONTINUOUS, around);
            answer[0] = (byte) heard;
            around.show(heard);
        }
    }

    private static int scale(int register) {
        int from = register < CALIBRATION ? FACTORY_DATA : CALIBRATION;
        int place = register - from;
        return place >= 0 && place < SCALE.length ? SCALE[place] : 0;
    }

    @Override
    public void write(int register, byte[] data, Surroundings around) {
        if (register == INTERVAL) {
            interval = data[0] & 0xff;
        } else if (register == MODE) {
            mode = data[0] == RESET ? OFF : data[0];
            listen(mode == ONCE, around);
        }
    }

    private void listen(boolean now, Surroundings around) {
        if (now) {
            heard = around.isExposed() ? around.value(0, NO_ECHO, "an ultrasonic sensor") : NO_ECHO;
        }
    }
}
