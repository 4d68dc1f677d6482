package lejos.robotics.subsumption;

/** Something that a robot does while nothing more important wants control. */
public interface Behavior {
    boolean takeControl();

    void action();

    /** Asks the action that is running to end. */
    void suppress();
}
