package arcomat.world;

/**
 * How far the world is from its ideal; standard deviations.
 *
 * @param light percent: of a reading, and twice that of a sensor as a whole
 * @param distance cm, likewise
 * @param wheels percent by which a wheel is larger or smaller than its mate
 * @param place mm by which a robot is set down beside its place
 * @param heading degrees by which it looks elsewhere
 */
public record Noise(double light, double distance, double wheels, double place, double heading) {
    public static final Noise USUAL = new Noise(1, 1, 0.5, 4, 1.5);
    public static final Noise NONE = new Noise(0, 0, 0, 0, 0);
}
