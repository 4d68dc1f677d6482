package arcomat.world.contact;

/** A body on wheels: it moves the way that these roll, and its tyres hold it in any other. */
public final class Rolling implements Body {
    private final double mass;
    private final double x;
    private final double y;
    private double speed;

    /**
     * @param x of the direction in which it rolls, a vector of length 1
     * @param y likewise
     */
    public Rolling(double mass, double x, double y, double speed) {
        this.mass = mass;
        this.x = x;
        this.y = y;
        this.speed = speed;
    }

    /** The way that it rolls. */
    public double speed() {
        return speed;
    }

    @Override
    public double speed(double towardsX, double towardsY) {
        return speed * share(towardsX, towardsY);
    }

    @Override
    public double mobility(double towardsX, double towardsY) {
        double share = share(towardsX, towardsY);
        return share * share / mass;
    }

    @Override
    public void push(double impulse, double towardsX, double towardsY) {
        speed += impulse * share(towardsX, towardsY) / mass;
    }

    private double share(double towardsX, double towardsY) {
        return x * towardsX + y * towardsY;
    }
}
