package arcomat.sim.load;

/** A jar that is not a program for a brick. The message says why, in the user's terms. */
public final class ProgramException extends Exception {
    public ProgramException(String message) {
        super(message);
    }
}
