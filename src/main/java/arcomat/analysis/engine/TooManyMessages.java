package arcomat.analysis.engine;

import arcomat.model.Port;

/** All messages of a port matter, and there are too many to try: the answer is unknown. */
public final class TooManyMessages extends RuntimeException {
    private static final long serialVersionUID = 1L;

    TooManyMessages(Port port) {
        super(
                "every value of port '"
                        + port.name()
                        + "' matters, and "
                        + port.type().name()
                        + " has too many to try; give it a range of at most "
                        + SmallType.MOST
                        + " values");
    }
}
