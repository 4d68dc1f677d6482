package arcomat.campaign.statistics;

/** How many trials a question takes, said before the first of them. */
public final class SampleSize {
    private SampleSize() {}

    /**
     * As many that the share of events is no farther than {@code error} from their probability,
     * whatever that is, as sure as {@code confidence} says (Okamoto: Some inequalities relating to
     * the partial sum of binomial probabilities, Annals of the Institute of Statistical Mathematics
     * 10, 1958; also known as Hoeffding's or Chernoff's bound).
     *
     * @param error absolute, between 0 and 1
     */
    public static long forError(double error, Confidence confidence) {
        return (long) StrictMath.ceil(StrictMath.log(2 / confidence.error()) / (2 * error * error));
    }

    /**
     * As many that have to be without a single event, to be as sure as {@code confidence} says that
     * its probability is at most {@code bound}.
     *
     * @param bound between 0 and 1
     */
    public static long withoutEvents(double bound, Confidence confidence) {
        return (long)
                StrictMath.ceil(StrictMath.log(confidence.error()) / StrictMath.log1p(-bound));
    }
}
