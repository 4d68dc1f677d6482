package lejos.nxt;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.MotorDevice;

/** The three sockets for motors. */
public class MotorPort implements TachoMotorPort {
    public static final int NUMBER_OF_PORTS = 3;

    private static final Hardware BRICK = Hardware.of(MotorPort.class);

    public static final MotorPort A = new MotorPort(0);
    public static final MotorPort B = new MotorPort(1);
    public static final MotorPort C = new MotorPort(2);

    private final int id;

    private MotorPort(int id) {
        this.id = id;
    }

    public static MotorPort getInstance(int id) {
        return switch (id) {
            case 0 -> A;
            case 1 -> B;
            case 2 -> C;
            default -> throw new IllegalArgumentException("no such motor port");
        };
    }

    public int getId() {
        return id;
    }

    /** The motor that is plugged in. */
    MotorDevice device() {
        return BRICK.called().motor(id);
    }

    @Override
    public void controlMotor(int power, int mode) {
        switch (mode) {
            case FORWARD -> device().power(power);
            case BACKWARD -> device().power(-power);
            case STOP -> device().brake();
            default -> device().letGo();
        }
    }

    /** Between pulses a simulated motor neither brakes nor floats. */
    @Override
    public void setPWMMode(int mode) {
        BRICK.called();
    }

    @Override
    public int getTachoCount() {
        return device().tachoCount();
    }

    @Override
    public void resetTachoCount() {
        device().resetTachoCount();
    }
}
