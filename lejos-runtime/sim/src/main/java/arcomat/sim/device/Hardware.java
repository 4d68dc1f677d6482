package arcomat.sim.device;

import arcomat.brick.api.BrickCost;
import arcomat.sim.memory.Heap;
import arcomat.sim.radio.Radio;
import arcomat.sim.time.SavedVariables;
import arcomat.sim.time.VirtualTime;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Everything that belongs to one brick. */
public final class Hardware {
    /** Bytes of the heap that leJOS takes for itself, before a program has made an object. */
    private static final int OF_LEJOS = 3500;

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
    private final Processor processor;
    private final Slices slices;
    private final Heap heap;
    private final Errors errors = new Errors();
    private final List<LineNotes> notes = new ArrayList<>();
    private Observer observer = new SilentObserver();
    private int batteryMillivolts = FULL_BATTERY;

    public Hardware(String name, VirtualTime time, Lifetime lifetime, Radio radio, Limits limits) {
        this.name = name;
        this.time = time;
        this.lifetime = lifetime;
        this.radio = radio;
        this.limits = limits;
        this.processor = new Processor(time, limits.counted());
        this.slices = new Slices(this);
        this.heap = new Heap(BrickCost.HEAP_BYTES - OF_LEJOS, lifetime::calls);
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

    public Processor processor() {
        return processor;
    }

    public Slices slices() {
        return slices;
    }

    public Heap heap() {
        return heap;
    }

    /**
     * What the brick does when a program is over, however it ended: it lets all motors go. One that
     * still turned runs out.
     */
    public void programEnded() {
        motors.forEach(MotorDevice::letGo);
    }

    /** What the brick does when nothing has caught an error: it shows what it knows. */
    public void programFailed(Throwable error) {
        errors.show(error, screen);
    }

    public Errors errors() {
        return errors;
    }

    public Observer observer() {
        return observer;
    }

    public void observe(Observer newObserver) {
        observer = newObserver;
    }

    /** Where a new object of the program notes, by their numbers, which lines it comes to. */
    public boolean[] notes(Object object, int size) {
        boolean[] reached = new boolean[size];
        notes.add(new LineNotes(object, reached));
        return reached;
    }

    /** What objects of the program have noted, in the order in which they were made. */
    public List<LineNotes> notes() {
        return List.copyOf(notes);
    }

    public int batteryMillivolts() {
        return batteryMillivolts;
    }

    public void setBatteryMillivolts(int millivolts) {
        batteryMillivolts = millivolts;
    }

    /** The program calls a device; every such call takes a little time. */
    public Hardware called() {
        processor.call();
        return this;
    }

    /** Sleeps up to a tick of the brick's clock, which counts milliseconds. */
    public void sleep(long milliseconds) {
        processor.rest();
        long from = time.now();
        time.waitUntil(tickAfter(milliseconds));
        slices.slept(from, milliseconds);
    }

    /** Like {@link #sleep}, but another thread may cut it short. */
    public void sleepInterruptibly(long milliseconds) throws InterruptedException {
        processor.rest();
        long from = time.now();
        time.waitInterruptibly(tickAfter(milliseconds));
        slices.slept(from, milliseconds);
    }

    /**
     * As {@link #sleepInterruptibly}, but the calling thread rests meanwhile: it has to leave all
     * its calls, and comes here a second time when the time has passed.
     */
    public void rest(long milliseconds) throws InterruptedException {
        SavedVariables saved = time.running().saved();
        if (time.running().resumes()) {
            time.rested();
            slices.slept(saved.takeNumber(), milliseconds);
        } else {
            processor.rest();
            long from = time.now();
            time.rest(tickAfter(milliseconds));
            saved.save(from);
        }
    }

    /** The moment of a tick of the brick's clock, so many milliseconds from now. */
    public long tickAfter(long milliseconds) {
        return (milliseconds() + Math.max(0, milliseconds)) * VirtualTime.MILLISECOND;
    }

    /** What the brick's clock shows. */
    public long milliseconds() {
        processor.look();
        return time.now() / VirtualTime.MILLISECOND;
    }
}
