package arcomat.campaign.statistics;

/**
 * Whether the probability of an event is at most {@code bound}, after a number of trials that was
 * settled before the first of them. By the one-sided bounds of {@link Proportion}:
 *
 * <ul>
 *   <li>where the probability is greater than the bound, the test says {@code HOLDS} with a
 *       probability of at most the error;
 *   <li>where it is not, the test says {@code FAILS} with a probability of at most the error.
 * </ul>
 *
 * Neither is true of who asks again and again as trials come in, and stops when the answer pleases:
 * that is what {@link SequentialTest} is for.
 *
 * @param bound from 0 to 1
 */
public record FixedTest(double bound, Confidence confidence) {
    /** The answer after all trials. */
    public Decision decide(Proportion seen) {
        if (seen.atMost(confidence) <= bound) {
            return Decision.HOLDS;
        }
        return seen.atLeast(confidence) > bound ? Decision.FAILS : Decision.UNDECIDED;
    }
}
