package arcomat.sim.time;

import java.math.BigDecimal;
import java.time.Duration;

/** Writes a time in seconds, to the millisecond: {@code 60}, {@code 0.5}. */
public final class SecondsText {
    /** Digits of a second. */
    private static final int MILLISECONDS = 3;

    private SecondsText() {}

    public static String of(Duration time) {
        return BigDecimal.valueOf(time.toMillis(), MILLISECONDS)
                .stripTrailingZeros()
                .toPlainString();
    }
}
