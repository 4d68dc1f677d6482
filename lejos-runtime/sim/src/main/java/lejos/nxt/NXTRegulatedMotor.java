package lejos.nxt;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.MotorDevice;
import arcomat.sim.device.MotorOrder;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * A motor with its speed and position regulated. Its listener hears of a rotation when the motor
 * starts from rest and when it comes to rest; as on the brick, an order to a motor that moves is no
 * new rotation, but here not even one that turns it round. Nothing blocks a simulated motor, so it
 * never stalls.
 */
public class NXTRegulatedMotor implements RegulatedMotor {
    protected static final int NO_LIMIT = 0x7fffffff;

    private static final Hardware BRICK = Hardware.of(NXTRegulatedMotor.class);
    private static final float SPEED_PER_VOLT = 100;
    private static final float MILLI = 1000;

    /** Milliseconds between two looks of the regulator. */
    private static final int PERIOD = 4;

    protected TachoMotorPort tachoPort;
    protected float speed = 360;
    protected int acceleration = 6000;
    protected int limitAngle;
    protected int stallLimit = 50;
    protected int stallTime = 1000;
    protected boolean stalled;
    protected RegulatedMotorListener listener;

    private boolean isWatched;
    private boolean isRotating;

    /**
     * @throws IllegalArgumentException if the port is not one of the brick's own; those of
     *     multiplexers are not simulated
     */
    public NXTRegulatedMotor(TachoMotorPort port) {
        if (!(port instanceof MotorPort)) {
            throw new IllegalArgumentException("only MotorPort.A, B and C are simulated");
        }
        this.tachoPort = port;
    }

    private MotorDevice device() {
        return ((MotorPort) tachoPort).device();
    }

    @Override
    public void forward() {
        turn(1);
    }

    @Override
    public void backward() {
        turn(-1);
    }

    private void turn(int direction) {
        MotorDevice device = device();
        boolean wasMoving = device.isMoving();
        limitAngle = direction * NO_LIMIT;
        device.turn(direction * speed, acceleration);
        started(wasMoving, device);
    }

    @Override
    public void stop() {
        stop(false);
    }

    @Override
    public void stop(boolean immediateReturn) {
        device().stop(acceleration);
        ended(immediateReturn);
    }

    @Override
    public void flt() {
        flt(false);
    }

    @Override
    public void flt(boolean immediateReturn) {
        device().letGo(acceleration);
        ended(immediateReturn);
    }

    @Override
    public void waitComplete() {
        MotorDevice device = device();
        while (device.isMoving()) {
            BRICK.time().waitUntil(Math.min(device.finished(), BRICK.tickAfter(1)));
        }
    }

    @Override
    public void rotate(int angle) {
        rotate(angle, false);
    }

    @Override
    public void rotate(int angle, boolean immediateReturn) {
        rotateTo(device().tachoCount() + angle, immediateReturn);
    }

    @Override
    public void rotateTo(int limitAngle) {
        rotateTo(limitAngle, false);
    }

    @Override
    public void rotateTo(int limitAngle, boolean immediateReturn) {
        MotorDevice device = device();
        boolean wasMoving = device.isMoving();
        this.limitAngle = limitAngle;
        device.turnTo(limitAngle, speed, acceleration);
        started(wasMoving, device);
        ended(immediateReturn);
    }

    /** As on the brick, a new speed also changes a turn that is going on. */
    @Override
    public void setSpeed(int speed) {
        setSpeed((float) speed);
    }

    public void setSpeed(float speed) {
        this.speed = Math.abs(speed);
        MotorDevice device = device();
        if (device.order() == MotorOrder.TURN && device.isMoving()) {
            device.turn(limitAngle < 0 ? -this.speed : this.speed, acceleration);
        } else if (device.order() == MotorOrder.TURN_TO && device.isMoving()) {
            device.turnTo(limitAngle, this.speed, acceleration);
        }
    }

    @Override
    public int getSpeed() {
        return Math.round(speed);
    }

    @Override
    public float getMaxSpeed() {
        return BRICK.batteryMillivolts() / MILLI * SPEED_PER_VOLT;
    }

    @Override
    public void setAcceleration(int acceleration) {
        this.acceleration = Math.abs(acceleration);
    }

    public int getAcceleration() {
        return acceleration;
    }

    @Override
    public int getLimitAngle() {
        return limitAngle;
    }

    public int getPosition() {
        return device().tachoCount();
    }

    @Override
    public int getTachoCount() {
        return device().tachoCount();
    }

    /** As on the brick, the motor stops first. */
    @Override
    public void resetTachoCount() {
        MotorDevice device = device();
        if (device.isMoving()) {
            stop(false);
        }
        device.resetTachoCount();
    }

    @Override
    public int getRotationSpeed() {
        return (int) Math.round(device().speed());
    }

    @Override
    public boolean isMoving() {
        return device().isMoving();
    }

    @Override
    public boolean isStalled() {
        return stalled;
    }

    @Override
    public void setStallThreshold(int error, int time) {
        stallLimit = error;
        stallTime = time / PERIOD;
    }

    /** Stops and holds, whatever the power. */
    public void lock(int power) {
        stop(false);
    }

    /** Lets the shaft go and waits until it rests. */
    public boolean suspendRegulation() {
        flt(false);
        return true;
    }

    /** As on the brick, there is one listener at most: the last one. */
    @Override
    public void addListener(RegulatedMotorListener listener) {
        this.listener = listener;
        if (!isWatched) {
            isWatched = true;
            ListenerThread.OF_MOTORS.watch(this::stopped, this::hasStopped, PERIOD);
        }
    }

    @Override
    public RegulatedMotorListener removeListener() {
        RegulatedMotorListener removed = listener;
        listener = null;
        return removed;
    }

    private void started(boolean wasMoving, MotorDevice device) {
        if (wasMoving || !device.isMoving()) {
            return;
        }
        isRotating = true;
        if (listener != null) {
            listener.rotationStarted(this, device.tachoCount(), false, BRICK.milliseconds());
        }
    }

    private void ended(boolean immediateReturn) {
        if (immediateReturn) {
            return;
        }
        waitComplete();
        if (isRotating) {
            stopped();
        }
    }

    private boolean hasStopped() {
        return isRotating && !isMoving();
    }

    /** Told by whoever sees it first: a call that waits for it, or the regulator. */
    private int stopped() {
        isRotating = false;
        if (listener != null) {
            listener.rotationStopped(this, getTachoCount(), false, BRICK.milliseconds());
        }
        return 0;
    }
}
