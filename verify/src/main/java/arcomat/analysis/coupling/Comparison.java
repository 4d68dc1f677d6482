package arcomat.analysis.coupling;

import arcomat.model.Expression;
import arcomat.model.Port;

import java.util.Optional;
import java.util.stream.Stream;

/** A condition over variables of both sides, as it stands in a certificate. */
record Comparison(Port variable, Relation relation, ComparedValue measure) {
    @SuppressWarnings("NullAway") // it stands in no model
    Claim claim() {
        return new Claim(
                relation,
                new Expression.PortRead(variable, null),
                measure.expression(variable.type()));
    }

    /** The variables that it is about. */
    Stream<Port> variables() {
        return Stream.concat(Stream.of(variable), measure.variable().stream());
    }

    /** Another variable, of the same type, that always has the same value. */
    Optional<Port> same() {
        return measure.variable()
                .filter(other -> relation == Relation.same(variable.type()))
                .filter(other -> other.type().equals(variable.type()) && !measure.isCalculated());
    }

    @Override
    public String toString() {
        return relation.text(variable.name(), measure.toString());
    }
}
