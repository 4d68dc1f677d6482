package arcomat.report.page;

/** How good news is. */
public enum Tone {
    GOOD,
    BAD,
    OPEN,
    NEUTRAL
}
