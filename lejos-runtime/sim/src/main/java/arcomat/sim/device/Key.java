package arcomat.sim.device;

/** The four buttons of a brick, each with the bit by which it is known inside. */
public enum Key {
    ENTER(1),
    LEFT(2),
    RIGHT(4),
    ESCAPE(8);

    private final int bit;

    Key(int bit) {
        this.bit = bit;
    }

    public int bit() {
        return bit;
    }
}
