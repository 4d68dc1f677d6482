package arcomat.analysis.search.composition;

import arcomat.model.Expression;
import arcomat.semantics.expression.Delivery.Message;
import arcomat.semantics.expression.Formulas;

import java.util.ArrayList;
import java.util.List;

/**
 * One way through a slice of a composition, as far as its parts have reacted, said over messages
 * from outside.
 *
 * @param happens that it is this one
 * @param visible by signal; what parts send without delay is put here
 * @param registers by signal; what they send with delay
 * @param stores what variables are given
 */
record SymbolicWay(
        Expression happens, Message[] visible, Message[] registers, List<Expression> stores) {
    /** A message of which nothing is known, by identity. */
    static final Message OPEN = Message.of(Formulas.TRUE);

    /** That steps are no expressions, or too many. */
    static final class Untold extends RuntimeException {
        private static final long serialVersionUID = 1L;
    }

    /** It goes on, under a condition that includes its own. */
    SymbolicWay after(Expression condition, List<Expression> stored) {
        List<Expression> all = new ArrayList<>(stores);
        all.addAll(stored);
        return new SymbolicWay(condition, visible.clone(), registers.clone(), all);
    }

    /** A message of which nothing is known, and that two can see, would be the same for both. */
    void put(int signal, Message message, Wiring wiring) {
        if (message == OPEN && wiring.observed[signal] && !wiring.readers.get(signal).isEmpty()) {
            throw new Untold();
        }
        (wiring.delayed[signal] ? registers : visible)[signal] = message;
    }

    /** What is seen of a signal outside, in this slice or in the next. */
    Message sent(int signal, Wiring wiring) {
        return (wiring.delayed[signal] ? registers : visible)[signal];
    }

    /** Whether a message is an expression for certain. */
    static boolean isTold(Message message) {
        return message != OPEN && message.isCertain();
    }

    /** Where one of both is false, it is; what goes wrong in the other is asked for by itself. */
    static Expression and(Expression one, Expression two) {
        return two.equals(Formulas.FALSE) ? two : Formulas.and(one, two);
    }
}
