package arcomat.brick;

/** Where a class of a robot's jar comes from. */
public enum Origin {
    /** Generated from models. */
    GENERATED,
    /** The runtime that generated code of every target needs. */
    RUNTIME,
    /** The platform library: sensors and actuators that come with the product. */
    PLATFORM,
    /** A team's own platform components. */
    HAND_WRITTEN
}
