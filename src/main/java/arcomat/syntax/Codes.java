package arcomat.syntax;

/** The codes of this room's findings. */
final class Codes {
    /** The text does not follow the grammar. */
    static final String SYNTAX = "ARC0001";

    /** The file defines nothing. */
    static final String EMPTY = "ARC0005";

    /** The text is nested too deep. */
    static final String NESTING = "ARC0006";

    private Codes() {}
}
