package arcomat.sim.bus;

/**
 * A device on the bus of a socket: what it answers to the program on a simulated brick. One object
 * is plugged in for one run, so that it may remember what was written to it.
 */
public interface I2CDevice {
    /** Where devices listen that follow LEGO's rules. */
    int USUAL_ADDRESS = 0x02;

    /**
     * The program reads registers.
     *
     * @param register the first one
     * @param answer a byte for each register, to be filled in; used again afterwards
     * @param around what the device senses, and when
     */
    void read(int register, byte[] answer, Surroundings around);

    /**
     * The program writes registers.
     *
     * @param register the first one
     * @param data a byte for each register; used again afterwards
     * @param around what the device senses, and when
     */
    void write(int register, byte[] data, Surroundings around);

    /** Where it listens: an even number, as leJOS counts addresses. */
    default int address() {
        return USUAL_ADDRESS;
    }
}
