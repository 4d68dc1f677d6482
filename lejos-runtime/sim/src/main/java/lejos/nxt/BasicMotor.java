package lejos.nxt;

import lejos.robotics.DCMotor;

/** A motor without regulation. */
public abstract class BasicMotor implements DCMotor {
    protected static int INVALID_MODE = -1;

    protected int mode = BasicMotorPort.FLOAT;
    protected BasicMotorPort port;
    protected int power;

    /** As on the brick, power given before a direction makes the motor start. */
    @Override
    public void setPower(int power) {
        this.power = power;
        port.controlMotor(power, mode == BasicMotorPort.FLOAT ? BasicMotorPort.FORWARD : mode);
    }

    @Override
    public int getPower() {
        return power;
    }

    @Override
    public void forward() {
        updateState(BasicMotorPort.FORWARD);
    }

    @Override
    public void backward() {
        updateState(BasicMotorPort.BACKWARD);
    }

    @Override
    public void stop() {
        updateState(BasicMotorPort.STOP);
    }

    @Override
    public void flt() {
        updateState(BasicMotorPort.FLOAT);
    }

    @Override
    public boolean isMoving() {
        return mode == BasicMotorPort.FORWARD || mode == BasicMotorPort.BACKWARD;
    }

    protected void updateState(int newMode) {
        mode = newMode;
        port.controlMotor(power, newMode);
    }
}
