package arcomat.sim.device;

/**
 * What a real brick does to programs that a PC would not, measured on leJOS NXJ 0.9.1.
 *
 * @param keyDelay microseconds for which no key changes before programs see which ones are down; a
 *     key that is released before has not been pressed
 * @param packetsInPieces whether some packets arrive in two parts, as on the air
 * @param counted whether objects take memory, calls take frames, and computing takes time; and
 *     whether errors look as they do there
 */
public record Limits(long keyDelay, boolean packetsInPieces, boolean counted) {
    /** As on the brick. */
    public static final Limits OF_THE_BRICK = new Limits(50_000, true, true);

    /** An ideal brick, for those who want to see their program alone. */
    public static final Limits NONE = new Limits(0, false, false);
}
