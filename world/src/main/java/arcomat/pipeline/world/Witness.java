package arcomat.pipeline.world;

import arcomat.sim.device.Observer;
import arcomat.world.World.Robot;

/**
 * Who watches a run of a world. A witness changes nothing: whoever watches, the run is the same.
 */
public interface Witness extends Onlooker {
    /** Who hears what the program of a robot does. Asked once, when the robot is switched on. */
    Observer of(Robot robot);

    /** A program has stopped with an error; told at the end. */
    void failed(String robot, String reason);

    /** What can be read on the robots. It is looked up when it is asked. */
    interface Instruments {
        /** Of a robot, in the order of its kind's sensors. */
        int[] readings(int robot);

        /** The first row of a robot's display; empty before the robot is switched on. */
        String display(int robot);
    }
}
