package arcomat.sim.inside;

import arcomat.sim.device.Hardware;

/** What somebody who looks at a program is told by it, and the program knows nothing of. */
public final class BrickProbes {
    private static final Hardware BRICK = Hardware.of(BrickProbes.class);

    private static final boolean[] REACHED = BRICK.reached();

    private BrickProbes() {}

    /** A line begins that somebody has asked about. */
    public static void reached(int number) {
        REACHED[number] = true;
    }

    /** A method begins that somebody has asked about. */
    public static void entered(Object object, String method) {
        BRICK.observer().entered(BRICK.time().now(), object, method);
    }

    /** It ends, other than by an exception. */
    public static void left(Object object, String method) {
        BRICK.observer().left(BRICK.time().now(), object, method);
    }
}
