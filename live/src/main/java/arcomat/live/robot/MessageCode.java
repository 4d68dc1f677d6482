package arcomat.live.robot;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Value.BooleanValue;
import arcomat.model.Value.EnumValue;
import arcomat.model.Value.IntegerValue;

import java.util.Optional;

/** Messages as numbers, as they go over the air: constants count from 1. */
final class MessageCode {
    private MessageCode() {}

    static int of(Value message) {
        if (message instanceof EnumValue constant) {
            return constant.ordinal() + 1;
        }
        return message instanceof BooleanValue truth
                ? truth.value() ? 1 : 0
                : (int) message.whole();
    }

    /** Empty for a number that is no constant: the other brick has another type. */
    static Optional<Value> read(int code, Type type) {
        if (type instanceof Type.EnumType constants) {
            return code < 1 || code > constants.constants().size()
                    ? Optional.empty()
                    : Optional.of(new EnumValue(constants, code - 1));
        }
        return Optional.of(
                type instanceof Type.BooleanType
                        ? new BooleanValue(code != 0)
                        : new IntegerValue(code));
    }
}
