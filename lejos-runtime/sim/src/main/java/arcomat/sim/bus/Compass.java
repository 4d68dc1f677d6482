package arcomat.sim.bus;

/** HiTechnic's compass: the value around it is its heading in degrees, clockwise from north. */
public final class Compass implements I2CDevice {
    private static final int VERSION = 0x00;
    private static final int VENDOR = 0x08;
    private static final int PRODUCT = 0x10;
    private static final int MODE = 0x41;
    private static final int HEADING = 0x42;
    private static final int FULL_TURN = 360;

    private int mode;

    @Override
    public void read(int register, byte[] answer, Surroundings around) {
        switch (register) {
            case VERSION -> Registers.text("V1.23", answer);
            case VENDOR -> Registers.text("HiTechnc", answer);
            case PRODUCT -> Registers.text("Compass", answer);
            case MODE -> Registers.number(mode, answer);
            case HEADING -> heading(answer, around);
            default -> Registers.number(0, answer);
        }
    }

    /** Half of it, and what the half has lost; behind them the same as a whole number. */
    private static void heading(byte[] answer, Surroundings around) {
        int degrees = around.value(0, FULL_TURN - 1, "a compass");
        int[] bytes = {degrees / 2, degrees % 2, degrees & 0xff, degrees >> 8};
        for (int i = 0; i < answer.length; i++) {
            answer[i] = i < bytes.length ? (byte) bytes[i] : 0;
        }
        around.show(degrees);
    }

    @Override
    public void write(int register, byte[] data, Surroundings around) {
        if (register == MODE) {
            mode = data[0];
        }
    }
}
