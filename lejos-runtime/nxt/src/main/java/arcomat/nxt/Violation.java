package arcomat.nxt;

/** The program does not keep what it watches itself for, and is not to go on. */
final class Violation extends RuntimeException {
    private static final long serialVersionUID = 1L;

    Violation(String text) {
        super(text);
    }
}
