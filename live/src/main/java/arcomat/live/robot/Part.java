package arcomat.live.robot;

import arcomat.model.Value;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/** A platform component at work: the calls that it makes of the brick's devices. */
interface Part {
    /** The program makes it. */
    default void begin() {}

    /**
     * The start of a slice.
     *
     * @param out takes the message, if there is one
     */
    default void sense(Consumer<Value> out) {}

    /**
     * The end of a slice.
     *
     * @param in the message on one of its ports, by its name
     */
    default void act(Function<String, Optional<Value>> in) {}
}
