package arcomat.sim.load;

/** A class file with something that does not begin anew; the message says what. */
final class Unrepeatable extends RuntimeException {
    private static final long serialVersionUID = 1L;

    Unrepeatable(String reason) {
        super(reason);
    }
}
