package arcomat.pipeline.world;

import arcomat.sim.device.MotorOrder;
import arcomat.sim.device.Observer;
import arcomat.sim.device.Screen;

/** Leaves out what is seen in the scenes, or not asked. */
abstract class Silent implements Observer {
    @Override
    public void sensorRead(long time, int socket, int value) {}

    @Override
    public void motorOrdered(long time, int motor, MotorOrder order, int value) {}

    @Override
    public void screenChanged(long time, Screen screen) {}

    @Override
    public void tonePlayed(long time, int hertz, int milliseconds) {}

    @Override
    public void packetReceived(long time, byte[] packet, int length) {}

    @Override
    public void slept(long from, long until) {}
}
