package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;

import java.util.List;

/** The ports that an expression reads. */
final class Readings {
    private Readings() {}

    static void collect(Expression e, List<Port> found) {
        if (e instanceof Expression.PortRead read) {
            found.add(read.port());
        } else if (e instanceof Expression.PortMatches matches) {
            found.add(matches.port());
            if (matches.pattern() instanceof Automaton.OneOf oneOf) {
                oneOf.values().forEach(value -> collect(value, found));
            }
        } else if (e instanceof Expression.Unary unary) {
            collect(unary.operand(), found);
        } else if (e instanceof Expression.Binary binary) {
            collect(binary.left(), found);
            collect(binary.right(), found);
        } else if (e instanceof Expression.Conditional choice) {
            collect(choice.condition(), found);
            collect(choice.then(), found);
            collect(choice.otherwise(), found);
        } else if (e instanceof Expression.IsIn isIn) {
            collect(isIn.element(), found);
            isIn.set().forEach(value -> collect(value, found));
        } else if (e instanceof Expression.Cast cast) {
            collect(cast.operand(), found);
        } else if (e instanceof Expression.AttributeRead read) {
            collect(read.object(), found);
        }
    }
}
