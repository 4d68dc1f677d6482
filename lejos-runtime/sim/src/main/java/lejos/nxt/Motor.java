package lejos.nxt;

/** The motors in the three sockets, regulated. */
public class Motor {
    public static final NXTRegulatedMotor A = new NXTRegulatedMotor(MotorPort.A);
    public static final NXTRegulatedMotor B = new NXTRegulatedMotor(MotorPort.B);
    public static final NXTRegulatedMotor C = new NXTRegulatedMotor(MotorPort.C);

    private Motor() {}

    public static NXTRegulatedMotor getInstance(int port) {
        return switch (port) {
            case 0 -> A;
            case 1 -> B;
            case 2 -> C;
            default -> throw new IllegalArgumentException("no such motor");
        };
    }
}
