package arcomat.live.robot;

import arcomat.model.Value;

import java.util.Optional;
import java.util.function.Function;

/** {@code nxt.RegulatedMotor}. */
record Turning(Shaft shaft) implements Part {
    @Override
    public void act(Function<String, Optional<Value>> in) {
        in.apply("speed").ifPresent(speed -> shaft.turn((int) speed.whole()));
    }
}
