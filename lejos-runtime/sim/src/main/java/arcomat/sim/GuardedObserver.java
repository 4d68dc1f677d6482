package arcomat.sim;

import arcomat.sim.device.MotorOrder;
import arcomat.sim.device.Observer;
import arcomat.sim.device.Screen;
import arcomat.sim.device.Stimulus;

import java.util.function.Consumer;

/**
 * Hands everything on to an observer. What that one throws comes neither into the program, which
 * might catch it, nor into what the world does: it is reported apart. Each method has its own
 * {@code try}: a lambda that shared one would allocate, and watching a robot allocates nothing.
 */
final class GuardedObserver implements Observer {
    private final Observer observer;
    private final Consumer<Throwable> whenFailed;

    /**
     * @param whenFailed is told what the observer throws
     */
    GuardedObserver(Observer observer, Consumer<Throwable> whenFailed) {
        this.observer = observer;
        this.whenFailed = whenFailed;
    }

    @Override
    public void sensorRead(long time, int socket, int value) {
        try {
            observer.sensorRead(time, socket, value);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void misfit(long time, int socket, String sensor, Stimulus stimulus) {
        try {
            observer.misfit(time, socket, sensor, stimulus);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void motorOrdered(long time, int motor, MotorOrder order, int value) {
        try {
            observer.motorOrdered(time, motor, order, value);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void screenChanged(long time, Screen screen) {
        try {
            observer.screenChanged(time, screen);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void tonePlayed(long time, int hertz, int milliseconds) {
        try {
            observer.tonePlayed(time, hertz, milliseconds);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void packetSent(long time, byte[] packet, int length) {
        try {
            observer.packetSent(time, packet, length);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void packetReceived(long time, byte[] packet, int length) {
        try {
            observer.packetReceived(time, packet, length);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void slept(long from, long until) {
        try {
            observer.slept(from, until);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void late(long from, long until) {
        try {
            observer.late(from, until);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void entered(long time, Object object, String method) {
        try {
            observer.entered(time, object, method);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }

    @Override
    public void left(long time, Object object, String method) {
        try {
            observer.left(time, object, method);
        } catch (RuntimeException | Error e) {
            whenFailed.accept(e);
        }
    }
}
