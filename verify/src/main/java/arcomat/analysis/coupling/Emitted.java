package arcomat.analysis.coupling;

import arcomat.model.Expression;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * What a step says about one output port.
 *
 * @param message the only one that is sent; empty where it is left open, or nothing is sent
 * @param open what else is said; of no matter where there is a message
 */
record Emitted(Optional<Expression> message, Sent open) {
    private static final List<Value> ONE = List.of(new Value.BooleanValue(true));

    static Emitted of(Expression message) {
        return new Emitted(Optional.of(message), Sent.SILENCE);
    }

    static Emitted of(Sent open) {
        return new Emitted(Optional.empty(), open);
    }

    Emitted with(UnaryOperator<Expression> rest) {
        return new Emitted(message.map(rest), open);
    }

    /** Whether all that another one may send is allowed, whichever message it is. */
    boolean allows(Emitted other) {
        return message.isEmpty()
                && (other.message.isPresent()
                        ? open.allows(ONE)
                        : open.meet(other.open).equals(Optional.of(other.open)));
    }
}
