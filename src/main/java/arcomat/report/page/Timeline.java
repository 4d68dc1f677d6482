package arcomat.report.page;

import java.util.List;

/**
 * Tracks side by side, all of the same length.
 *
 * @param unit what a step is called: {@code slice}, {@code event}
 * @param times of the steps in milliseconds; empty where steps have no time
 * @param flaws where it goes wrong
 */
public record Timeline(
        String unit, int length, List<Long> times, List<Track> tracks, List<Flaw> flaws) {
    public Timeline {
        times = List.copyOf(times);
        tracks = List.copyOf(tracks);
        flaws = List.copyOf(flaws);
    }

    /** No steps at all. */
    public static Timeline none(String unit) {
        return new Timeline(unit, 0, List.of(), List.of(), List.of());
    }

    /**
     * A step at which a track is not as it should be.
     *
     * @param track its name; empty for the step as a whole
     */
    public record Flaw(int at, String track, String text) {}
}
