package arcomat.world.contact;

/**
 * Two bodies that touch, or may in this step. They do not bounce: what they take of each other's
 * speed is just so much that they come no nearer than they may.
 */
public final class Contact {
    private final Body one;
    private final Body other;
    private final double x;
    private final double y;
    private final double nearing;
    private double impulse;

    /**
     * @param x of the direction from one to the other, a vector of length 1
     * @param y likewise
     * @param nearing the speed at which they may come nearer in this step; below 0, they are too
     *     near
     */
    Contact(Body one, Body other, double x, double y, double nearing) {
        this.one = one;
        this.other = other;
        this.x = x;
        this.y = y;
        this.nearing = nearing;
    }

    /** At which speed the first one goes to where the other one is. */
    public double speed() {
        return one.speed(x, y);
    }

    /** Whether one pushes the other. */
    public boolean pushes() {
        return impulse > 0;
    }

    /** Whether there is less room between them than there has to be. */
    boolean isTooNear() {
        return nearing < 0;
    }

    /** They come no nearer than they may, and where they are too near, no nearer at all. */
    void settle() {
        settle(Math.max(0, nearing));
    }

    /** Where they are too near, they also go apart. */
    void part() {
        settle(nearing);
    }

    private void settle(double most) {
        double mobility = one.mobility(x, y) + other.mobility(x, y);
        if (mobility > 0) {
            double excess = one.speed(x, y) - other.speed(x, y) - most;
            double whole = Math.max(0, impulse + excess / mobility);
            one.push(impulse - whole, x, y);
            other.push(whole - impulse, x, y);
            impulse = whole;
        }
    }
}
