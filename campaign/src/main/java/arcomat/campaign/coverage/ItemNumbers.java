package arcomat.campaign.coverage;

/**
 * Under which numbers is noted what somebody covers of an automaton; they go on from these.
 *
 * @param transition of the first transition
 * @param initial of the first beginning
 */
public record ItemNumbers(int transition, int initial) {}
