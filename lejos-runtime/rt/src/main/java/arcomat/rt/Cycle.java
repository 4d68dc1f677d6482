package arcomat.rt;

/** The clock of a program: slices of equal length. Durations in models count slices. */
public final class Cycle {
    private final int milliseconds;
    private long next;

    public Cycle(int milliseconds) {
        this.milliseconds = milliseconds;
        this.next = System.currentTimeMillis();
    }

    /**
     * Waits for the next slice. A slice that took too long shortens the wait for the following
     * ones, so that slices keep their rate.
     *
     * @return false if the program has been interrupted and should end
     */
    public boolean await() {
        long wait = next - System.currentTimeMillis();
        next += milliseconds;
        try {
            if (wait > 0) {
                Thread.sleep(wait);
            }
            return true;
        } catch (InterruptedException e) {
            return false;
        }
    }
}
