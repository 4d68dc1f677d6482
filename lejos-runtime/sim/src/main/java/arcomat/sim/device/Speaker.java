package arcomat.sim.device;

import arcomat.sim.time.VirtualTime;

/** The speaker. It plays on its own; a program need not wait. */
public final class Speaker {
    private final Hardware hardware;
    private long silentFrom;

    Speaker(Hardware hardware) {
        this.hardware = hardware;
    }

    public void play(int hertz, int milliseconds) {
        long now = hardware.time().now();
        silentFrom = now + milliseconds * VirtualTime.MILLISECOND;
        hardware.observer().tonePlayed(now, hertz, milliseconds);
    }

    /** Milliseconds until the last tone is over. */
    public int remaining() {
        long left = silentFrom - hardware.time().now();
        return (int) Math.max(0, (left + VirtualTime.MILLISECOND - 1) / VirtualTime.MILLISECOND);
    }
}
