package arcomat.sim;

import arcomat.sim.device.LineNotes;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.Observer;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/** A brick as what is around it sees it, whatever its program is and whoever runs it. */
public interface Brick {
    /** The name by which other bricks call this one over Bluetooth. */
    String name();

    /** Watches the program from now on, instead of whoever watched before. */
    void observe(Observer observer);

    /**
     * Exposes a sensor to something that need not be known before the program asks for it.
     *
     * @param source says what it is; asked once at most. It must not wait, nor let time pass, and
     *     has to say the same until the sensor is exposed to something else
     */
    void expose(SensorName socket, Supplier<Stimulus> source);

    /** The speed of a motor in degrees per second, as it turns now. */
    double speed(MotorName name);

    /** A row of the screen, from 0, without spaces at its end. */
    String row(int number);

    boolean isRunning();

    /** What went wrong, for the user of the program; empty where nothing did. */
    Optional<String> failure();

    /**
     * Which lines objects of the program have come to, of those that are noted; in the order in
     * which they were made.
     */
    List<LineNotes> notes();
}
