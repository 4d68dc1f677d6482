package arcomat.world.contact;

/** A body that lies on the floor, and moves in any direction. */
public final class Sliding implements Body {
    private final double mass;
    private double along;
    private double across;

    /**
     * @param along its speed along x
     * @param across its speed along y
     */
    public Sliding(double mass, double along, double across) {
        this.mass = mass;
        this.along = along;
        this.across = across;
    }

    double mass() {
        return mass;
    }

    public double along() {
        return along;
    }

    public double across() {
        return across;
    }

    @Override
    public double speed(double x, double y) {
        return along * x + across * y;
    }

    @Override
    public double mobility(double x, double y) {
        return 1 / mass;
    }

    @Override
    public void push(double impulse, double x, double y) {
        along += impulse * x / mass;
        across += impulse * y / mass;
    }
}
