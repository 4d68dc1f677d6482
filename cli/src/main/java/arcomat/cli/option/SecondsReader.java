package arcomat.cli.option;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

import java.math.BigDecimal;
import java.time.Duration;

/** Reads a time in seconds, {@code 60} or {@code 0.5}: a nanosecond to 292 years. */
public final class SecondsReader implements ITypeConverter<Duration> {
    /** Digits of a second. */
    private static final int NANOSECONDS = 9;

    private static final BigDecimal SHORTEST = BigDecimal.valueOf(1, NANOSECONDS);
    private static final BigDecimal LONGEST = BigDecimal.valueOf(Long.MAX_VALUE, NANOSECONDS);

    @Override
    public Duration convert(String written) {
        try {
            BigDecimal seconds = new BigDecimal(written);
            if (seconds.compareTo(SHORTEST) >= 0 && seconds.compareTo(LONGEST) <= 0) {
                return Duration.ofNanos(seconds.movePointRight(NANOSECONDS).longValue());
            }
            throw notTime(written);
        } catch (NumberFormatException e) {
            throw notTime(written);
        }
    }

    private static TypeConversionException notTime(String written) {
        return new TypeConversionException(
                "'" + written + "' is not a time; give more than 0 seconds, as in 60 or 0.5");
    }
}
