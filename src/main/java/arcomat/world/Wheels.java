package arcomat.world;

/**
 * Two driven wheels.
 *
 * @param left motor, 1 to 3
 * @param right motor, 1 to 3
 * @param diameter in mm
 * @param track from wheel to wheel, in mm
 */
public record Wheels(int left, int right, double diameter, double track) {
    /** How far a wheel rolls for one degree, in mm. */
    double roll() {
        return Math.PI * diameter / 360;
    }
}
