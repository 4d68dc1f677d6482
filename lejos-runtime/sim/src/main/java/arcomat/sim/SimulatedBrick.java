package arcomat.sim;

import arcomat.sim.bus.I2CDevice;
import arcomat.sim.device.Hardware;
import arcomat.sim.device.Key;
import arcomat.sim.device.Limits;
import arcomat.sim.device.LineNotes;
import arcomat.sim.device.MotorDevice;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.Observer;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.SilentObserver;
import arcomat.sim.device.Stimulus;
import arcomat.sim.load.BrickLoader;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.radio.Ether;
import arcomat.sim.script.Action;
import arcomat.sim.script.Script;
import arcomat.sim.time.Strand;
import arcomat.sim.time.VirtualTime;

import java.lang.invoke.MethodHandle;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * A brick with a program, in a {@link Laboratory}. Everything here acts at the moment at which the
 * laboratory's time stands, and takes no time itself.
 */
public final class SimulatedBrick implements Brick, Action.Receiver {
    private final Hardware hardware;
    private final ProgramThreads threads;
    private final BrickLoader loader;

    SimulatedBrick(
            String name, LoadedProgram program, VirtualTime time, Ether ether, Limits limits) {
        threads = new ProgramThreads(name, time, this::programOver, program.carriers());
        hardware = new Hardware(name, time, threads, ether.join(name), limits);
        loader = program.take(hardware);
        threads.startMain(() -> runMain(program.mainClass()));
    }

    private void programOver() {
        hardware.programEnded();
        if (hardware.limits().counted()) {
            threads.outcome()
                    .error()
                    .filter(error -> !(error instanceof ObserverFailed))
                    .ifPresent(hardware::programFailed);
        }
    }

    /** As on the brick, main gets no arguments, not even an empty array. */
    private void runMain(String mainClass) {
        Strand strand = hardware.time().running();
        if (strand.resumes()) {
            loader.goOn(Objects.requireNonNull(strand.saved().takeObject()));
            return;
        }
        MethodHandle main;
        try {
            main = loader.main(mainClass);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(
                    mainClass + " has no method public static void main(String[])", e);
        }
        try {
            main.invokeExact((String[]) null);
        } catch (Throwable e) {
            throw ProgramFailure.unwrapped(e);
        }
    }

    @Override
    public String name() {
        return hardware.name();
    }

    public Outcome outcome() {
        return threads.outcome();
    }

    @Override
    public Optional<String> failure() {
        return outcome().failure();
    }

    @Override
    public boolean isRunning() {
        return outcome().kind() == Outcome.Kind.RUNNING;
    }

    /** An observer that throws something ends the program, whose failure that is. */
    @Override
    public void observe(Observer observer) {
        hardware.observe(new GuardedObserver(observer, this::observerFailed));
    }

    private void observerFailed(Throwable error) {
        hardware.observe(new SilentObserver());
        threads.observerFailed(new ObserverFailed(error));
    }

    /** Plays a script; its times count from switching on. */
    public void play(Script script) {
        ScriptPlayer player = new ScriptPlayer(this, script.steps());
        hardware.time().start(player, player.due());
    }

    /**
     * Puts a device into a socket: whatever classes of leJOS the program talks to it with, this is
     * what answers on the bus.
     */
    public void plug(SensorName socket, I2CDevice device) {
        hardware.socket(socket.ordinal()).bus().plug(device);
    }

    @Override
    public void expose(SensorName socket, Stimulus stimulus) {
        hardware.socket(socket.ordinal()).expose(stimulus);
    }

    @Override
    public void expose(SensorName socket, Supplier<Stimulus> source) {
        hardware.socket(socket.ordinal()).expose(source);
    }

    @Override
    public void press(Key key) {
        hardware.keypad().press(key);
    }

    @Override
    public void release(Key key) {
        hardware.keypad().release(key);
    }

    public MotorState motor(MotorName name) {
        MotorDevice motor = hardware.motor(name.ordinal());
        return new MotorState(motor.order(), motor.value(), motor.speed(), motor.tachoCount());
    }

    @Override
    public double speed(MotorName name) {
        return hardware.motor(name.ordinal()).speed();
    }

    @Override
    public String row(int number) {
        return hardware.screen().row(number);
    }

    /** The rows of the screen from top to bottom, without spaces at their ends. */
    public List<String> screen() {
        return hardware.screen().rows();
    }

    @Override
    public List<LineNotes> notes() {
        return hardware.notes();
    }

    public void setBattery(int millivolts) {
        hardware.setBatteryMillivolts(millivolts);
    }

    /** Switches the brick off. What the program still tries to do has no effect. */
    @Override
    public void stop() {
        hardware.observe(new SilentObserver());
        threads.end(Outcome.of(Outcome.Kind.STOPPED));
    }

    /** Another brick may have the classes, once nothing runs in them any more. */
    void leave() {
        if (threads.areOver()) {
            loader.leave();
        }
    }
}
