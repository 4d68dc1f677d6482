package arcomat.live.robot;

import arcomat.model.Value;
import arcomat.sim.device.Hardware;

import java.util.Optional;
import java.util.function.Function;

/**
 * {@code nxt.Speaker}.
 *
 * @param duration of a tone, in milliseconds
 */
record Sounding(Routine routine, Hardware brick, int duration) implements Part {
    @Override
    public void act(Function<String, Optional<Value>> in) {
        in.apply("frequency")
                .ifPresent(
                        hertz ->
                                routine.call(
                                        () -> brick.speaker().play((int) hertz.whole(), duration)));
    }
}
