package arcomat.analysis.coupling;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;

/** A condition over variables of both sides, as it stands in a certificate. */
record Comparison(Port variable, BinaryOperator operator, ComparedValue measure) {
    @SuppressWarnings("NullAway") // it stands in no model
    Expression expression() {
        return new Expression.Binary(
                operator,
                new Expression.PortRead(variable, null),
                measure.expression(variable.type()),
                new Type.BooleanType(),
                null);
    }

    @Override
    public String toString() {
        return variable.name() + " " + operator.sign() + " " + measure;
    }
}
