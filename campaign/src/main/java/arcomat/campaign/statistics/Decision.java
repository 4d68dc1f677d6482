package arcomat.campaign.statistics;

/** What a test has to say about a requirement; what each word promises is said by the test. */
public enum Decision {
    HOLDS,
    FAILS,
    /** There are not enough trials to say either. */
    UNDECIDED
}
