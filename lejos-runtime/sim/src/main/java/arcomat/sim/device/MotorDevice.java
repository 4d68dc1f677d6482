package arcomat.sim.device;

import arcomat.sim.time.VirtualTime;

/**
 * A motor with its tachometer. Regulated turning accelerates evenly and then keeps its speed;
 * unregulated turning reaches a speed proportional to power. Nothing ever blocks the shaft.
 */
public final class MotorDevice {
    /** Speed at full power without load, with a full battery. */
    private static final double FULL_SPEED = 900;

    private static final double UNREGULATED_ACCELERATION = 3000;

    /** How fast friction stops a motor that is let go. */
    private static final double FRICTION = 1000;

    private final Hardware hardware;
    private final int number;
    private final Trajectory trajectory = new Trajectory();
    private MotorOrder order = MotorOrder.FLOAT;
    private int value;
    private double zero;

    MotorDevice(Hardware hardware, int number) {
        this.hardware = hardware;
        this.number = number;
    }

    /** Turns at a speed in degrees per second, negative backwards, until told otherwise. */
    public void turn(double speed, double acceleration) {
        trajectory.reach(now(), speed, acceleration);
        ordered(MotorOrder.TURN, (int) Math.round(speed));
    }

    /** Turns to a position that counts from the last reset of the tachometer. */
    public void turnTo(int position, double speed, double acceleration) {
        trajectory.goTo(now(), position + zero, speed, acceleration);
        ordered(MotorOrder.TURN_TO, position);
    }

    /** Turns without regulation. */
    public void power(int percent) {
        trajectory.reach(now(), FULL_SPEED * percent / 100, UNREGULATED_ACCELERATION);
        ordered(MotorOrder.POWER, percent);
    }

    /** Stops and holds the shaft. */
    public void stop(double acceleration) {
        trajectory.reach(now(), 0, acceleration);
        ordered(MotorOrder.STOP, 0);
    }

    /** Stops and lets the shaft go; a regulated stop brakes first. */
    public void letGo(double acceleration) {
        trajectory.reach(now(), 0, acceleration);
        ordered(MotorOrder.FLOAT, 0);
    }

    /** Lets the shaft go without braking. */
    public void letGo() {
        letGo(FRICTION);
    }

    public void brake() {
        stop(UNREGULATED_ACCELERATION * 2);
    }

    public int tachoCount() {
        return (int) Math.round(trajectory.position(now()) - zero);
    }

    public void resetTachoCount() {
        zero = trajectory.position(now());
    }

    /** Degrees per second at this moment. */
    public double speed() {
        return trajectory.speed(now());
    }

    /** Whether the last order still lets the shaft turn. */
    public boolean isMoving() {
        return order == MotorOrder.TURN || order == MotorOrder.POWER
                ? value != 0 || now() < trajectory.settled()
                : now() < trajectory.settled();
    }

    /** When the last order is carried out; never, if it is to keep turning. */
    public long finished() {
        boolean endless = (order == MotorOrder.TURN || order == MotorOrder.POWER) && value != 0;
        return endless ? VirtualTime.NEVER : trajectory.settled();
    }

    public MotorOrder order() {
        return order;
    }

    /** The number that goes with the order. */
    public int value() {
        return value;
    }

    private void ordered(MotorOrder newOrder, int newValue) {
        if (newOrder == order && newValue == value) {
            return;
        }
        order = newOrder;
        value = newValue;
        hardware.observer().motorOrdered(now(), number, newOrder, newValue);
    }

    private long now() {
        return hardware.time().now();
    }
}
