package arcomat.sim.script;

import arcomat.sim.device.Key;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;

/** Something that happens to a brick. */
public sealed interface Action {
    /** A sensor is exposed to something from now on. */
    record Expose(SensorName socket, Stimulus stimulus) implements Action {}

    /** A button goes down. */
    record Press(Key key) implements Action {}

    /** A button comes up. */
    record Release(Key key) implements Action {}

    /** The brick is switched off. */
    record End() implements Action {}
}
