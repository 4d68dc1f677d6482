package arcomat.sim.trace;

import arcomat.sim.device.MotorName;
import arcomat.sim.device.MotorOrder;
import arcomat.sim.device.Observer;
import arcomat.sim.device.Screen;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;

/**
 * Writes down what a program does. Text is drawn in pieces, and nobody sees the steps: pieces that
 * follow each other closely are one change of the screen. Who wants to see what is not written
 * down, such as probes, extends it.
 */
public class Recorder implements Observer {
    private static final SensorName[] SENSORS = SensorName.values();

    /** Microseconds between pieces that belong together. */
    private static final long CLOSELY = 5000;

    private static final MotorName[] MOTORS = MotorName.values();

    private final List<Misfit> misfits = new ArrayList<>();
    private final List<Cycle> cycles = new ArrayList<>();
    private List<Event> events = new ArrayList<>();
    private long start;
    private Event.@Nullable ScreenChanged drawn;
    private Lateness lateness = Lateness.NONE;

    /**
     * A sensor that was exposed to what it cannot sense.
     *
     * @param time microseconds since switching on, when the program read it
     * @param sensor what the program takes it for
     */
    public record Misfit(long time, SensorName socket, String sensor, Stimulus stimulus) {}

    /** Exposures that did not fit, in the order in which they were read. */
    public List<Misfit> misfits() {
        return List.copyOf(misfits);
    }

    /** All that has happened so far; the last cycle may be unfinished. */
    public Trace trace() {
        flushScreen();
        List<Cycle> all = new ArrayList<>(cycles);
        all.add(new Cycle(start, events));
        return new Trace(all);
    }

    @Override
    public void slept(long from, long until) {
        endCycle(until);
    }

    private void endCycle(long next) {
        flushScreen();
        cycles.add(new Cycle(start, events));
        events = new ArrayList<>();
        start = next;
    }

    @Override
    public void late(long from, long until) {
        endCycle(until);
        lateness = lateness.and(until - from);
    }

    /** How often the program came late. */
    public Lateness lateness() {
        return lateness;
    }

    @Override
    public void sensorRead(long time, int socket, int value) {
        events.add(new Event.SensorRead(time, SENSORS[socket], value));
    }

    @Override
    public void misfit(long time, int socket, String sensor, Stimulus stimulus) {
        misfits.add(new Misfit(time, SENSORS[socket], sensor, stimulus));
    }

    @Override
    public void motorOrdered(long time, int motor, MotorOrder order, int value) {
        events.add(new Event.MotorOrdered(time, MOTORS[motor], order, value));
    }

    @Override
    public void screenChanged(long time, Screen screen) {
        if (drawn != null && time - drawn.time() > CLOSELY) {
            flushScreen();
        }
        drawn = new Event.ScreenChanged(time, screen.rows());
    }

    private void flushScreen() {
        if (drawn != null) {
            events.add(drawn);
            events.sort(Comparator.comparingLong(Event::time));
            drawn = null;
        }
    }

    @Override
    public void tonePlayed(long time, int hertz, int milliseconds) {
        events.add(new Event.TonePlayed(time, hertz, milliseconds));
    }

    @Override
    public void packetSent(long time, byte[] packet, int length) {
        events.add(new Event.PacketSent(time, hexadecimal(packet, length)));
    }

    @Override
    public void packetReceived(long time, byte[] packet, int length) {
        events.add(new Event.PacketReceived(time, hexadecimal(packet, length)));
    }

    private static String hexadecimal(byte[] packet, int length) {
        return HexFormat.of().formatHex(packet, 0, length);
    }
}
