package arcomat.brick.need;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.LongSupplier;

/**
 * How much of something a program needs, if that can be told from its code.
 *
 * @param amount none if it is not known
 * @param unknown why it is not known: part of a sentence
 */
public record Need(OptionalLong amount, Optional<String> unknown) {
    static Need of(LongSupplier amount) {
        try {
            return new Need(OptionalLong.of(amount.getAsLong()), Optional.empty());
        } catch (Unknown e) {
            return new Need(OptionalLong.empty(), Optional.of(e.getMessage()));
        } catch (ArithmeticException e) {
            return new Need(OptionalLong.empty(), Optional.of("it is beyond all numbers"));
        }
    }

    /** Whether it is known to be more than this. */
    public boolean isAbove(double limit) {
        return amount.isPresent() && amount.getAsLong() > limit;
    }
}
