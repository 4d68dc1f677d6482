package arcomat.sim.device;

import arcomat.sim.radio.Radio;
import arcomat.sim.time.VirtualTime;

import java.util.List;
import java.util.stream.IntStream;

/** Everything that belongs to one brick. */
public final class Hardware {
    /**
     * Microseconds that a call of a device takes: enough for a loop that only asks to see time
     * pass.
     */
    private static final long CALL = 20;

    private static final int FULL_BATTERY = 7400;

    private final String name;
    private final VirtualTime time;
    private final Lifetime lifetime;
    private final Radio radio;
    private final List<MotorDevice> motors;
    private final List<SensorSocket> sockets;
    private final Screen screen;
    private final Keypad keypad;
    private final Speaker speaker;
    private final Limits limits;
    private Observer observer = Observer.NONE;
    private int batteryMillivolts = FULL_BATTERY;

    public Hardware(String name, VirtualTime time, Lifetime lifetime, Radio radio, Limits limits) {
        this.name = name;
        this.time = time;
        this.lifetime = lifetime;
        this.radio = radio;
        this.limits = limits;
        this.motors = IntStream.range(0, 3).mapToObj(i -> new MotorDevice(this, i)).toList();
        this.sockets = IntStream.range(0, 4).mapToObj(i -> new SensorSocket(this, i)).toList();
        this.screen = new Screen(this);
        this.keypad = new Keypad(time, limits.keyDelay(), lifetime::abort);
        this.speaker = new Speaker(this);
    }

    /**
     * The brick to which a class belongs. Classes of lejos.* are loaded anew for every brick, by a
     * loader that knows its brick; so they need no variable that names it.
     */
    public static Hardware of(Class<?> inside) {
        if (inside.getClassLoader() instanceof Inside loader) {
            return loader.hardware();
        }
        throw new IllegalStateException(
                inside.getName()
                        + " works inside a simulated brick only: run the program with"
                        + " arcomat.sim.SimulatedBrick");
    }

    /** A class loader that stands for a brick. */
    public interface Inside {
        Hardware hardware();
    }

    public String name() {
        return name;
    }

    public VirtualTime time() {
        return time;
    }

    public Lifetime lifetime() {
        return lifetime;
    }

    public Radio radio() {
        return radio;
    }

    public MotorDevice motor(int number) {
        return motors.get(number);
    }

    public SensorSocket socket(int number) {
        return sockets.get(number);
    }

    public Screen screen() {
        return screen;
    }

    public Keypad keypad() {
        return keypad;
    }

    public Speaker speaker() {
        return speaker;
    }

    public Limits limits() {
        return limits;
    }

    /**
     * What the brick does when a program is over, however it ended: it lets all motors go. One that
     * still turned runs out.
     */
    public void programEnded() {
        motors.forEach(MotorDevice::letGo);
    }

    public Observer observer() {
        return observer;
    }

    public void observe(Observer newObserver) {
        observer = newObserver;
    }

    public int batteryMillivolts() {
        return batteryMillivolts;
    }

    public void setBatteryMillivolts(int millivolts) {
        batteryMillivolts = millivolts;
    }

    /** The program calls a device; every such call takes a little time. */
    public Hardware called() {
        time.spend(CALL);
        return this;
    }

    /** Sleeps up to a tick of the brick's clock, which counts milliseconds. */
    public void sleep(long milliseconds) {
        long from = time.now();
        time.waitUntil(tickAfter(milliseconds));
        slept(from);
    }

    /** Like {@link #sleep}, but another thread may cut it short. */
    public void sleepInterruptibly(long milliseconds) throws InterruptedException {
        long from = time.now();
        time.waitInterruptibly(tickAfter(milliseconds));
        slept(from);
    }

    private void slept(long from) {
        if (lifetime.isMain()) {
            observer.slept(from, time.now());
        }
    }

    /** The moment of a tick of the brick's clock, so many milliseconds from now. */
    public long tickAfter(long milliseconds) {
        return (milliseconds() + Math.max(0, milliseconds)) * VirtualTime.MILLISECOND;
    }

    /** What the brick's clock shows. */
    public long milliseconds() {
        return time.now() / VirtualTime.MILLISECOND;
    }
}
