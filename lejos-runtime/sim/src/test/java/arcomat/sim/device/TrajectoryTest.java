package arcomat.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;

/** However a shaft is ordered about, it moves as a body with bounded acceleration must. */
class TrajectoryTest {
    private static final long STEP = 10_000;
    private static final double SECOND = 1e6;

    @Property(tries = 300)
    void itMovesSmoothlyAndArrives(
            @ForAll @DoubleRange(min = -900, max = 900) double first,
            @ForAll @IntRange(min = 0, max = 1_000_000) int meanwhile,
            @ForAll @DoubleRange(min = -2000, max = 2000) double target,
            @ForAll @DoubleRange(min = 10, max = 900) double limit,
            @ForAll @DoubleRange(min = 100, max = 6000) double rate) {
        Trajectory trajectory = new Trajectory();
        trajectory.reach(0, first, rate);
        trajectory.goTo(meanwhile, target, limit, rate);
        long end = trajectory.settled();
        assertThat(trajectory.position(end)).isCloseTo(target, within(1e-6));
        assertThat(trajectory.speed(end)).isZero();
        for (long time = meanwhile; time < Math.min(end, 10_000_000); time += STEP) {
            double change = trajectory.speed(time + STEP) - trajectory.speed(time);
            assertThat(Math.abs(change)).isLessThanOrEqualTo(rate * STEP / SECOND + 1e-6);
            double way = trajectory.position(time + STEP) - trajectory.position(time);
            double average = (trajectory.speed(time) + trajectory.speed(time + STEP)) / 2;
            assertThat(way).isCloseTo(average * STEP / SECOND, within(0.2));
        }
    }

    @Property(tries = 300)
    void itReachesItsSpeed(
            @ForAll @DoubleRange(min = -900, max = 900) double first,
            @ForAll @DoubleRange(min = -900, max = 900) double second,
            @ForAll @IntRange(min = 0, max = 1_000_000) int meanwhile) {
        Trajectory trajectory = new Trajectory();
        trajectory.reach(0, first, 1000);
        trajectory.reach(meanwhile, second, 1000);
        assertThat(trajectory.speed(trajectory.settled())).isEqualTo(second);
        assertThat(trajectory.settled()).isLessThanOrEqualTo(meanwhile + 1_800_001L);
    }
}
