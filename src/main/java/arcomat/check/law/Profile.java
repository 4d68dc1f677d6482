package arcomat.check.law;

/** What a set of models is checked for. */
public enum Profile {
    /** Models that say what is wanted; they may leave open how it is done. */
    REQUIREMENTS,
    /** Models that code is to be generated from. */
    EXECUTABLE
}
