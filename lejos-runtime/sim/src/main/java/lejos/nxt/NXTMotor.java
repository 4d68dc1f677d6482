package lejos.nxt;

import lejos.robotics.Encoder;
import lejos.robotics.EncoderMotor;

/** A motor of the NXT without regulation. */
public class NXTMotor extends BasicMotor implements EncoderMotor {
    protected Encoder encoderPort;

    public NXTMotor(TachoMotorPort port) {
        this(port, BasicMotorPort.PWM_BRAKE);
    }

    public NXTMotor(TachoMotorPort port, int PWMMode) {
        this.port = port;
        this.encoderPort = port;
        this.power = MAX_POWER;
        port.setPWMMode(PWMMode);
    }

    private static final int MAX_POWER = BasicMotorPort.MAX_POWER;

    @Override
    public int getTachoCount() {
        return encoderPort.getTachoCount();
    }

    @Override
    public void resetTachoCount() {
        encoderPort.resetTachoCount();
    }
}
