package arcomat.sim.time;

import java.time.Duration;

/** Programs took longer, by the PC's clock, than they were given. Their threads may still run. */
public final class OutOfPatience extends RuntimeException {
    private static final long serialVersionUID = 1L;

    OutOfPatience(Duration patience) {
        super("no end after " + patience.toSeconds() + " s of the PC's time");
    }
}
