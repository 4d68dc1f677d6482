package arcomat.sim.device;

/** The sockets for sensors. */
public enum SensorName {
    S1,
    S2,
    S3,
    S4
}
