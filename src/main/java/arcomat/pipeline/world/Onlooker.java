package arcomat.pipeline.world;

import arcomat.world.Scene;

import java.util.BitSet;

/** Who looks at a world while it runs, and changes nothing. */
@FunctionalInterface
public interface Onlooker {
    /** Sees nothing. */
    Onlooker NOBODY = (scene, instruments) -> {};

    /**
     * The world at a moment: as it begins, and after each step.
     *
     * @param instruments what there is to read on the robots at this moment; later it is something
     *     else
     */
    void see(Scene scene, Witness.Instruments instruments);

    /**
     * A program has come to a method at which it has a probe.
     *
     * @param object the program's own, on which the method was called; to be looked at
     */
    default void entered(String robot, Object object, String method) {}

    /** It has come to the end of that method, other than by an exception. */
    default void left(String robot, Object object, String method) {}

    /**
     * Told at the end, if it comes to one.
     *
     * @param numbers of the lines that the robot's program has come to, of those that have a probe
     */
    default void reached(String robot, BitSet numbers) {}
}
