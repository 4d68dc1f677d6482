package arcomat.sim.inside;

import arcomat.sim.device.Hardware;

/** What somebody who looks at a program is told by it, and the program knows nothing of. */
public final class BrickProbes {
    private static final Hardware BRICK = Hardware.of(BrickProbes.class);

    private BrickProbes() {}

    /** An object begins that notes which lines it comes to: here it does. */
    public static boolean[] notes(Object object, int size) {
        return BRICK.notes(object, size);
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
