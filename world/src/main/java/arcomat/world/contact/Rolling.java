package arcomat.world.contact;

/** A body on wheels: it moves the way that these roll, and its tyres hold it in any other. */
public final class Rolling implements Body {
    private final double mass;
    private final double x;
    private final double y;
    private final double least;
    private final double most;

    /** The speed that it would have without tyres that hold it. */
    private double pushed;

    private Rolling(double mass, double x, double y, double speed, double least, double most) {
        this.mass = mass;
        this.x = x;
        this.y = y;
        this.pushed = speed;
        this.least = least;
        this.most = most;
    }

    /**
     * Its wheels turn.
     *
     * @param x of the direction in which it rolls, a vector of length 1
     * @param y likewise
     */
    public static Rolling free(double mass, double x, double y, double speed) {
        double any = Double.POSITIVE_INFINITY;
        return new Rolling(mass, x, y, speed, -any, any);
    }

    /**
     * Its wheels stand: however hard it is pushed, its tyres keep it from becoming faster or going
     * back. Others may stop it, by no more than the momentum that it still has.
     *
     * @param x of the direction in which it rolls, a vector of length 1
     * @param y likewise
     */
    public static Rolling held(double mass, double x, double y, double speed) {
        return new Rolling(mass, x, y, speed, Math.min(0, speed), Math.max(0, speed));
    }

    /** The way that it rolls. */
    public double speed() {
        return Math.max(least, Math.min(most, pushed));
    }

    @Override
    public double speed(double towardsX, double towardsY) {
        return speed() * share(towardsX, towardsY);
    }

    @Override
    public double mobility(double towardsX, double towardsY) {
        double share = share(towardsX, towardsY);
        return least == most ? 0 : share * share / mass;
    }

    @Override
    public void push(double impulse, double towardsX, double towardsY) {
        pushed += impulse * share(towardsX, towardsY) / mass;
    }

    private double share(double towardsX, double towardsY) {
        return x * towardsX + y * towardsY;
    }
}
