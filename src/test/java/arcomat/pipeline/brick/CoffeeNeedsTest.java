package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import arcomat.brick.need.Needs;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * What is predicted against what robots needed on leJOS' own virtual machine, linked with its own
 * linker. On the preparer the constant part of the memory was calibrated, on the dispenser the time
 * of the ultrasonic sensor, and on the barista what Bluetooth takes; the other two test them.
 *
 * <p>Classes are exact; all but the courier have two fewer than when they were measured, for
 * nothing in them has to be checked any more. A slice is predicted longer than any that was seen,
 * never shorter. The tolerances are what is left of the difference, at most 25 %: where a robot has
 * too many slices to look at, branches of several components count together that never come
 * together, and on all of them motors are regulated all the time.
 */
class CoffeeNeedsTest {
    private static final double KILOBYTE = 1000;
    private static final double MILLISECOND = 1000;
    private static final double MEMORY_TOLERANCE = 8;

    @ParameterizedTest
    @CsvSource({
        "fetcher.Fetcher, 114, 4.3, 9.8, 10",
        "dispenser.Dispenser, 110, 4.1, 6.7, 13",
        "preparer.Preparer, 108, 3.9, 1.8, 15",
        "floor.Courier, 139, 6.5, 14, 8",
        "floor.Barista, 121, 6.1, 1.8, 23"
    })
    void isWhatWasMeasured(
            String robot, int classes, double memory, double slice, double tolerance) {
        Needs needs = CoffeeRobot.of("coffee." + robot).built().robots().get(0).report().needs();

        assertThat(needs.isExact()).isTrue();
        assertThat(needs.classes()).isEqualTo(classes);
        assertThat(needs.memory().amount().orElseThrow() / KILOBYTE)
                .isCloseTo(memory, withinPercentage(MEMORY_TOLERANCE));
        assertThat(needs.slice().amount().orElseThrow() / MILLISECOND)
                .isGreaterThanOrEqualTo(slice)
                .isCloseTo(slice, withinPercentage(tolerance));
        assertThat(needs.cycle()).hasValue(100);
    }
}
