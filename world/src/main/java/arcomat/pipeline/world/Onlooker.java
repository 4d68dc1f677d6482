package arcomat.pipeline.world;

import arcomat.sim.device.LineNotes;
import arcomat.world.Scene;

import java.util.List;

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
     * @param notes which lines objects of the robot's program have come to; good until this returns
     */
    default void noted(String robot, List<LineNotes> notes) {}
}
