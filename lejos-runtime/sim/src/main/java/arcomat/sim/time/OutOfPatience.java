package arcomat.sim.time;

import java.time.Duration;

/** Programs took longer, by the PC's clock, than they were given. Their threads may still run. */
public final class OutOfPatience extends RuntimeException {
    private static final long serialVersionUID = 1L;

    OutOfPatience(Duration patience) {
        super("no end after " + limit(patience));
    }

    /** A limit in words: {@code 0.5 s of the PC's time}. */
    public static String limit(Duration patience) {
        return SecondsText.of(patience) + " s of the PC's time";
    }
}
