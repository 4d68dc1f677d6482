package lejos.nxt.comm;

import arcomat.sim.device.Hardware;
import arcomat.sim.radio.Link;
import arcomat.sim.time.VirtualTime;

import java.util.Optional;

/** Bluetooth: one brick waits, another connects by name. */
public class Bluetooth extends NXTCommDevice {
    private static final Hardware BRICK = Hardware.of(Bluetooth.class);

    /** How long a brick tries to reach another before it gives up. */
    private static final long PATIENCE = 5000;

    /** Making a connection takes its time even when the other listens. */
    private static final long HANDSHAKE = 500;

    private Bluetooth() {}

    public static BTConnection waitForConnection() {
        return waitForConnection(0, NXTConnection.PACKET);
    }

    /**
     * Waits for another brick.
     *
     * @param timeout in milliseconds; 0 for ever
     * @return null if nobody came
     */
    public static BTConnection waitForConnection(int timeout, int mode) {
        VirtualTime time = BRICK.time();
        long end = timeout == 0 ? VirtualTime.NEVER - 1 : BRICK.tickAfter(timeout);
        Optional<Link> link = BRICK.radio().awaitCall(time, end);
        time.waitUntil(BRICK.tickAfter(1));
        return connection(link, mode);
    }

    /**
     * Connects to another brick.
     *
     * @return null if it is unknown or does not listen
     */
    public static BTConnection connect(String target, int mode) {
        if (!BRICK.called().radio().knows(target)) {
            return null;
        }
        long end = BRICK.milliseconds() + PATIENCE;
        Optional<Link> link = BRICK.radio().connect(target);
        while (link.isEmpty() && BRICK.milliseconds() < end) {
            BRICK.time().waitUntil(BRICK.tickAfter(1));
            link = BRICK.radio().connect(target);
        }
        BRICK.time().waitUntil(BRICK.time().now() + HANDSHAKE * VirtualTime.MILLISECOND);
        return connection(link, mode);
    }

    private static BTConnection connection(Optional<Link> link, int mode) {
        return link.map(made -> new BTConnection(made, mode)).orElse(null);
    }

    public static String getFriendlyName() {
        return BRICK.name();
    }

    public static boolean getPower() {
        return true;
    }

    /** The simulated radio is always on. */
    public static void setPower(boolean on) {
        BRICK.called();
    }
}
