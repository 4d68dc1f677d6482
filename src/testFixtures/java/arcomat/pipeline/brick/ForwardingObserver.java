package arcomat.pipeline.brick;

import arcomat.sim.device.MotorOrder;
import arcomat.sim.device.Observer;
import arcomat.sim.device.Screen;

/** Hands everything on; for observers that are curious about one thing. */
public abstract class ForwardingObserver implements Observer {
    private final Observer next;

    public ForwardingObserver(Observer next) {
        this.next = next;
    }

    @Override
    public void sensorRead(long time, int socket, int value) {
        next.sensorRead(time, socket, value);
    }

    @Override
    public void motorOrdered(long time, int motor, MotorOrder order, int value) {
        next.motorOrdered(time, motor, order, value);
    }

    @Override
    public void screenChanged(long time, Screen screen) {
        next.screenChanged(time, screen);
    }

    @Override
    public void tonePlayed(long time, int hertz, int milliseconds) {
        next.tonePlayed(time, hertz, milliseconds);
    }

    @Override
    public void packetSent(long time, byte[] packet, int length) {
        next.packetSent(time, packet, length);
    }

    @Override
    public void packetReceived(long time, byte[] packet, int length) {
        next.packetReceived(time, packet, length);
    }
}
