package arcomat.world.contact;

/** A body, as far as impulses change its speed. Directions are vectors of length 1. */
public interface Body {
    /** Nothing moves it. */
    Body FIXED =
            new Body() {
                @Override
                public double speed(double x, double y) {
                    return 0;
                }

                @Override
                public double mobility(double x, double y) {
                    return 0;
                }

                @Override
                public void push(double impulse, double x, double y) {}
            };

    /** Its speed in a direction. */
    double speed(double x, double y);

    /** By how much that speed grows with an impulse of 1 in the direction. */
    double mobility(double x, double y);

    /** Takes an impulse in a direction. */
    void push(double impulse, double x, double y);
}
