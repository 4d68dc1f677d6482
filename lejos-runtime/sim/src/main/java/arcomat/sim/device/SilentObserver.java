package arcomat.sim.device;

/** Sees nothing; who is interested in a few things overrides those. */
public class SilentObserver implements Observer {
    @Override
    public void sensorRead(long time, int socket, int value) {}

    @Override
    public void motorOrdered(long time, int motor, MotorOrder order, int value) {}

    @Override
    public void screenChanged(long time, Screen screen) {}

    @Override
    public void tonePlayed(long time, int hertz, int milliseconds) {}

    @Override
    public void packetSent(long time, byte[] packet, int length) {}

    @Override
    public void packetReceived(long time, byte[] packet, int length) {}

    @Override
    public void slept(long from, long until) {}
}
