package arcomat.sim.bus;

/** LEGO's temperature sensor: the value around it is in whole degrees Celsius. */
public final class Thermometer implements I2CDevice {
    private static final int ADDRESS = 0x98;
    private static final int TEMPERATURE = 0;
    private static final int CONFIGURATION = 1;
    private static final int COLDEST = -55;
    private static final int HOTTEST = 127;

    private int configuration;

    @Override
    public int address() {
        return ADDRESS;
    }

    @Override
    public void read(int register, byte[] answer, Surroundings around) {
        if (register == TEMPERATURE) {
            int degrees = around.value(COLDEST, HOTTEST, "a temperature sensor");
            Registers.number(degrees, answer);
            around.show(degrees);
        } else {
            Registers.number(register == CONFIGURATION ? configuration : 0, answer);
        }
    }

    @Override
    public void write(int register, byte[] data, Surroundings around) {
        if (register == CONFIGURATION) {
            configuration = data[0];
        }
    }
}
