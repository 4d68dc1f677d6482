package arcomat.sim.device;

import arcomat.sim.bus.Surroundings;

import org.jspecify.annotations.Nullable;

import java.util.function.Supplier;

/** One of the four sockets for sensors, with whatever the sensor in it is exposed to. */
public final class SensorSocket implements Surroundings {
    private static final int RAW_LIMIT = 1023;

    /** What a pressed touch sensor lets through. */
    private static final int RAW_PRESSED = 183;

    private static final int NO_COLOR = -1;

    /** As lejos.robotics.Color counts them. */
    private static final int LAST_COLOR = 13;

    private final Hardware hardware;
    private final int number;
    private final I2CBus bus;
    private final ColorEye eye = new ColorEye(this);
    private Stimulus stimulus = Stimulus.NONE;

    /** Says what the stimulus is; null where that is known. */
    private @Nullable Supplier<Stimulus> source;

    private boolean isTold;

    SensorSocket(Hardware hardware, int number) {
        this.hardware = hardware;
        this.number = number;
        this.bus = new I2CBus(this, hardware.time());
    }

    /** What a colour sensor sees here. */
    public ColorEye eye() {
        return eye;
    }

    /** Where a device listens that is asked by two wires. */
    public I2CBus bus() {
        return bus;
    }

    public void expose(Stimulus newStimulus) {
        stimulus = newStimulus;
        source = null;
        isTold = false;
        bus.connect(!is(Stimulus.Kind.NONE));
    }

    /** As {@link #expose(Stimulus)}, to something that is asked when the program wants to know. */
    public void expose(Supplier<Stimulus> newSource) {
        source = newSource;
        isTold = false;
        bus.connect(true);
    }

    public Stimulus stimulus() {
        if (source != null) {
            stimulus = source.get();
            source = null;
        }
        return stimulus;
    }

    @Override
    public long microseconds() {
        return hardware.time().now();
    }

    @Override
    public boolean isExposed() {
        return !is(Stimulus.Kind.NONE);
    }

    @Override
    public int value() {
        return stimulus().number();
    }

    @Override
    public int value(int least, int most, String sensor) {
        boolean isNumber = is(Stimulus.Kind.VALUE) || !isExposed();
        check(isNumber && isWithin(least, most), sensor);
        return isNumber ? Math.min(Math.max(value(), least), most) : most;
    }

    @Override
    public void show(int value) {
        observed(value);
    }

    /** A device is asked by two wires, and nobody has said what it is. */
    void checkKnown(boolean known) {
        check(known, "an I2C device that nobody describes");
    }

    /** A colour's number as lejos.robotics.Color counts. */
    int color() {
        boolean known = is(Stimulus.Kind.COLOR) || is(Stimulus.Kind.VALUE);
        check(known && isWithin(NO_COLOR, LAST_COLOR), "a colour sensor");
        return known ? stimulus().number() : NO_COLOR;
    }

    /** The raw value of a switch. */
    public int rawSwitch() {
        check(!is(Stimulus.Kind.COLOR) && (is(Stimulus.Kind.RAW) || isWithin(0, 1)), "a switch");
        return switch (stimulus().kind()) {
            case NONE -> RAW_LIMIT;
            case VALUE, SWITCH, COLOR -> stimulus().number() != 0 ? RAW_PRESSED : RAW_LIMIT;
            case RAW -> stimulus().number();
        };
    }

    /**
     * The raw value of a sensor whose voltage falls with what it senses. A percentage outside 0 to
     * 100 is not cut off: tests of programs need what no surface in this world gives.
     */
    public int rawLevel() {
        check(!is(Stimulus.Kind.COLOR) && !is(Stimulus.Kind.SWITCH), "a light or sound sensor");
        return switch (stimulus().kind()) {
            case NONE -> RAW_LIMIT;
            case VALUE, SWITCH, COLOR -> RAW_LIMIT - awayFromZero(stimulus().number());
            case RAW -> stimulus().number();
        };
    }

    private boolean is(Stimulus.Kind kind) {
        return stimulus().kind() == kind;
    }

    private boolean isWithin(int least, int most) {
        return stimulus().number() >= least && stimulus().number() <= most;
    }

    /** A socket without anything is no fault of the program, nor of the script. */
    private void check(boolean fits, String sensor) {
        if (!fits && !isTold && !is(Stimulus.Kind.NONE)) {
            isTold = true;
            hardware.observer().misfit(hardware.time().now(), number, sensor, stimulus());
        }
    }

    /** Such that the usual division of the raw value gives the percentage back. */
    private static int awayFromZero(int percent) {
        int scaled = Math.abs(percent) * RAW_LIMIT;
        return Integer.signum(percent) * ((scaled + 99) / 100);
    }

    /** For a device that does not say what it is: the number as it is. */
    public int rawAny() {
        return stimulus().kind() == Stimulus.Kind.NONE ? RAW_LIMIT : stimulus().number();
    }

    /** Tells whoever watches what a program has read here. */
    public int observed(int value) {
        hardware.observer().sensorRead(hardware.time().now(), number, value);
        return value;
    }
}
