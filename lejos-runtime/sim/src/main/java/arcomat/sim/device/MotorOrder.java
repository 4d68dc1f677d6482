package arcomat.sim.device;

/** What a motor can be told; the number that goes with it. */
public enum MotorOrder {
    /** Keep turning: degrees per second, negative is backwards. */
    TURN,
    /** Turn to a position: degrees. */
    TURN_TO,
    /** Turn without regulation: percent of full power, negative is backwards. */
    POWER,
    /** Stop and hold. */
    STOP,
    /** Stop and let go. */
    FLOAT
}
