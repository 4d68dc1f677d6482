package arcomat.cli.terminal;

/** What the command's exit status says. */
public final class ExitStatus {
    public static final int FINE = 0;

    /** The models have errors, a test failed, a file is not formatted. */
    public static final int FINDINGS = 1;

    /** The command was used wrongly, its input could not be read, or its output not written. */
    public static final int WRONG_USE = 2;

    /** An analysis or a stream test could not be decided. */
    public static final int UNKNOWN = 3;

    private ExitStatus() {}
}
