package arcomat.analysis.bits;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.GivenUp;

/**
 * What expressions find where they are evaluated, but for messages, which may be any. In a letter,
 * there are neither variables nor parameters.
 */
interface BitReads {
    /** A literal: a port carries a message. */
    int has(Port port);

    default int[] variable(Expression.VariableRead read) {
        throw BitExpressions.noBits(read);
    }

    default Value argument(Expression.ParameterRead read) {
        throw BitExpressions.noBits(read);
    }

    /**
     * What is taken for the value of an expression that has no bits.
     *
     * @throws GivenUp where nothing is
     */
    default int[] instead(Expression e, GivenUp noBits) {
        throw noBits;
    }
}
