package arcomat.cli;

/** What the command's exit status says. */
final class ExitStatus {
    static final int FINE = 0;

    /** The models have errors, a test failed, a file is not formatted. */
    static final int FINDINGS = 1;

    /** The command was used wrongly, its input could not be read, or its output not written. */
    static final int WRONG_USE = 2;

    /** An analysis or a stream test could not be decided. */
    static final int UNKNOWN = 3;

    private ExitStatus() {}
}
