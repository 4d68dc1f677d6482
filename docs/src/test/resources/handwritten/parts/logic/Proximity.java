package parts.logic;

/** Tells from a distance whether something is too close; between near and far it says nothing. */
public final class Proximity {
    public static final int UNKNOWN = 0;
    public static final int CLEAR = 1;
    public static final int TOO_CLOSE = 2;

    private final int near;
    private final int far;

    public Proximity(int near, int far) {
        this.near = near;
        this.far = far;
    }

    public int judge(int distance) {
        if (distance <= near) {
            return TOO_CLOSE;
        }
        return distance >= far ? CLEAR : UNKNOWN;
    }
}
