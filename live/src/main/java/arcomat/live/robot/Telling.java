package arcomat.live.robot;

import arcomat.model.Value;

import java.util.Optional;
import java.util.function.Function;

/** {@code nxt.LcdLogger}. */
record Telling(Lettering row) implements Part {
    @Override
    public void act(Function<String, Optional<Value>> in) {
        in.apply("text").ifPresent(text -> row.show(((Value.StringValue) text).value()));
    }
}
