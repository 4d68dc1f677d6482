package arcomat.sim;

/** An observer of a program has thrown something: the program is over, by no fault of its own. */
final class ObserverFailed extends RuntimeException {
    ObserverFailed(Throwable error) {
        super("an observer of the program failed: " + error, error);
        // The place that is told is that in the observer.
        setStackTrace(error.getStackTrace());
    }

    @Override
    public String toString() {
        return String.valueOf(getMessage());
    }
}
