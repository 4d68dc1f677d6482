package arcomat.sim.device;

/**
 * Sees what a program does with its brick. Numbers are primitive, so that watching a program does
 * not make it allocate. Times are microseconds since switching on.
 */
public interface Observer {
    /** The program has read a sensor and got this value. */
    void sensorRead(long time, int socket, int value);

    /**
     * The program has read a sensor that cannot be exposed to what it is exposed to; told once for
     * each exposure.
     *
     * @param sensor what the program takes it for
     */
    default void misfit(long time, int socket, String sensor, Stimulus stimulus) {}

    /** A motor was told something new; repeating an order is not reported. */
    void motorOrdered(long time, int motor, MotorOrder order, int value);

    /** The text on the screen is another one. */
    void screenChanged(long time, Screen screen);

    void tonePlayed(long time, int hertz, int milliseconds);

    void packetSent(long time, byte[] packet, int length);

    void packetReceived(long time, byte[] packet, int length);

    /** The program's first thread has slept: in the usual main loop, between two cycles. */
    void slept(long from, long until);

    /** A round of the main loop took so long that it ended without a wait. */
    default void late(long from, long until) {}

    /**
     * A method begins at which there is a probe.
     *
     * @param object the program's own, on which it was called; to be looked at, and left as it is
     */
    default void entered(long time, Object object, String method) {}

    /** The method ends, other than by an exception. */
    default void left(long time, Object object, String method) {}
}
