package arcomat.campaign;

import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.ConfidenceInterval;
import arcomat.campaign.statistics.Families;
import arcomat.campaign.statistics.Splitting;

import java.util.List;
import java.util.Optional;

/**
 * What a splitting says of how rare it is that a distance becomes as small as its last level.
 *
 * @param levels those that were tried: none behind one that no run has reached
 * @param families of the runs that came to the last of them
 * @param runs of all levels
 * @param givenUp how many of them took too long
 * @param nearest absent where no run has such a distance
 */
public record RareEvent(
        Campaign.Split split,
        List<Splitting.Level> levels,
        Families families,
        long runs,
        long givenUp,
        Optional<Nearest> nearest) {
    public RareEvent {
        levels = List.copyOf(levels);
    }

    /**
     * A run that comes nearer than all others, the first of those that do.
     *
     * @param millimetres its distance
     */
    public record Nearest(Row row, double millimetres) {}

    /**
     * Nobody knows how runs would have ended that were given up, and which ones would have begun in
     * them: then nothing is said.
     */
    public boolean isKnown() {
        return givenUp == 0 && !levels.isEmpty();
    }

    /** Right on average, where it is known. Among runs whose values make a world. */
    public double estimate() {
        return splitting().estimate();
    }

    /** Where it is known. */
    public ConfidenceInterval interval(Confidence confidence) {
        return splitting().interval(families, confidence);
    }

    private Splitting splitting() {
        return new Splitting(levels);
    }

    /** What is asked, in mm. */
    public int event() {
        return split.levels().get(split.levels().size() - 1);
    }
}
