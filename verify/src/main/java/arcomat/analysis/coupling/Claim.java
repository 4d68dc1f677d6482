package arcomat.analysis.coupling;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Scope;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** That two expressions are related. */
record Claim(Relation relation, Expression one, Expression other) {
    /** About other things. */
    Claim rewritten(UnaryOperator<Expression> rule) {
        return new Claim(relation, one.rewritten(rule), other.rewritten(rule));
    }

    /** What is asked, or denied, in the words of models; empty where they have none. */
    @SuppressWarnings("NullAway") // it stands in no model
    Optional<Expression> asked() {
        return relation.operator()
                .map(each -> new Expression.Binary(each, one, other, new Type.BooleanType(), null));
    }

    /**
     * Whether it is so of some values.
     *
     * @param row by position of the port
     */
    boolean isTrue(List<Port> ports, Value[] row) {
        Scope scope = Scope.ofPorts(ports);
        return asked().map(e -> scope.isTrue(e, row) != relation.isDenied())
                .orElseGet(
                        () ->
                                Objects.requireNonNull(scope.value(one, row))
                                        .equals(scope.value(other, row)));
    }
}
