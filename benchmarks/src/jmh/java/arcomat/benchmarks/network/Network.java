package arcomat.benchmarks.network;

/** Chains of small components, all fed with the same input; one slice of delay in each part. */
public interface Network {
    /**
     * Performs a slice per message.
     *
     * @param messages what comes from outside, 0 for no message
     * @return what the ends of the chains sent, folded into one number
     */
    int run(int[] messages);
}
