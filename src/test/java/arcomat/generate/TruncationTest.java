package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.rt.Check;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What generated code makes of a number is what Java makes of it, by conversions that a brick can
 * do.
 */
class TruncationTest {
    @ParameterizedTest
    @ValueSource(
            doubles = {
                0,
                -0.0,
                2.9,
                -2.9,
                9.2e18,
                -9.2e18,
                9.223372036854774e18,
                9.223372036854775e18,
                -9.223372036854775e18,
                9.223372036854775807e18,
                -9.223372036854775808e18,
                9.3e18,
                -9.3e18,
                1e300,
                -1e300,
                Float.MAX_VALUE,
                Double.MIN_VALUE,
                Double.POSITIVE_INFINITY,
                Double.NEGATIVE_INFINITY,
                Double.NaN
            })
    void isThatOfJava(double number) {
        assertThat(Check.truncate(number)).isEqualTo((long) number);
    }
}
