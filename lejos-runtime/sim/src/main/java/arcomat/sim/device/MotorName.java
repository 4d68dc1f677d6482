package arcomat.sim.device;

/** The sockets for motors. */
public enum MotorName {
    A,
    B,
    C
}
