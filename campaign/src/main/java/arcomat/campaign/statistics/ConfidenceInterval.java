package arcomat.campaign.statistics;

/**
 * Where the truth is, as far as one can be sure; both ends belong to it.
 *
 * @param low negative infinity where nothing is known
 * @param high infinity where nothing is known
 */
public record ConfidenceInterval(double low, double high) {
    public ConfidenceInterval {
        if (!(low <= high)) {
            throw new IllegalArgumentException("from " + low + " to " + high);
        }
    }

    public boolean contains(double value) {
        return low <= value && value <= high;
    }
}
