package arcomat.live.browser;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

/** As Java divides, which does so here by itself. */
class DivisionTest {
    private static final long[] NUMBERS = {
        Long.MIN_VALUE, Integer.MIN_VALUE, -7, -2, -1, 1, 2, 7, Integer.MAX_VALUE, Long.MAX_VALUE
    };

    @Test
    void longs() {
        for (long dividend : NUMBERS) {
            for (long divisor : NUMBERS) {
                assertThat(Division.quotient(dividend, divisor)).isEqualTo(dividend / divisor);
                assertThat(Division.remainder(dividend, divisor)).isEqualTo(dividend % divisor);
            }
            assertThatThrownBy(() -> Division.quotient(dividend, 0L)).hasMessage("/ by zero");
            assertThatThrownBy(() -> Division.remainder(dividend, 0L)).hasMessage("/ by zero");
        }
    }

    @Test
    void integers() {
        for (long number : NUMBERS) {
            int dividend = (int) number;
            for (long other : NUMBERS) {
                int divisor = other == Long.MIN_VALUE ? Integer.MIN_VALUE : (int) other;
                assertThat(Division.quotient(dividend, divisor)).isEqualTo(dividend / divisor);
                assertThat(Division.remainder(dividend, divisor)).isEqualTo(dividend % divisor);
            }
            assertThatThrownBy(() -> Division.quotient(dividend, 0)).hasMessage("/ by zero");
            assertThatThrownBy(() -> Division.remainder(dividend, 0)).hasMessage("/ by zero");
        }
    }
}
