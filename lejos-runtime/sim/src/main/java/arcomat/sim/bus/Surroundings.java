package arcomat.sim.bus;

/** What is around a device at the moment at which it is asked. */
public interface Surroundings {
    /** Microseconds since the brick was switched on. */
    long microseconds();

    /** Whether the script or the world has said what the device senses. */
    boolean isExposed();

    /** The number that script or world expose the socket to; 0 as long as there is none. */
    int value();

    /**
     * As {@link #value()}, for a device that cannot sense everything: what lies outside is cut off,
     * and whoever runs the program is told.
     *
     * @param sensor what it is, with its article: "an ultrasonic sensor"
     */
    int value(int least, int most, String sensor);

    /** Tells whoever watches what the program gets: a row of the trace. */
    void show(int value);
}
