package arcomat.semantics.value;

import arcomat.model.Port;
import arcomat.model.Type;

/** There are too many letters to try. */
public final class TooManyMessages extends GivenUp {
    private static final long serialVersionUID = 1L;

    private TooManyMessages(String reason) {
        super(reason);
    }

    /** All messages of a port matter. */
    public static TooManyMessages on(Port port) {
        return new TooManyMessages(
                "every value of port '"
                        + port.name()
                        + "' matters, and "
                        + port.type().name()
                        + " has too many to try"
                        + advice(port.type()));
    }

    private static String advice(Type type) {
        return type instanceof Type.IntegerType
                ? "; give it a range of at most " + SmallType.MOST + " values"
                : "";
    }

    /** What matters of several ports is too much together. */
    public static TooManyMessages together(int most) {
        return new TooManyMessages(
                "one configuration tells more than " + most + " inputs apart, too many to try");
    }
}
