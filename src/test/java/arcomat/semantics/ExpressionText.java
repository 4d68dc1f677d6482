package arcomat.semantics;

import arcomat.model.Automaton;
import arcomat.model.Expression;

/** A short form of conditions for tests: {@code m?} is presence, {@code p--} absence. */
public final class ExpressionText {
    private ExpressionText() {}

    public static String of(Expression e) {
        if (e instanceof Expression.Binary binary) {
            String operator =
                    switch (binary.operator()) {
                        case AND -> "&&";
                        case OR -> "||";
                        default -> binary.operator().name();
                    };
            return "(" + of(binary.left()) + " " + operator + " " + of(binary.right()) + ")";
        }
        if (e instanceof Expression.Unary unary) {
            return "!" + of(unary.operand());
        }
        if (e instanceof Expression.PortRead read) {
            return read.port().name();
        }
        if (e instanceof Expression.PortMatches matches) {
            return matches.port() + (matches.pattern() instanceof Automaton.Absent ? "--" : "?");
        }
        return ((Expression.Constant) e).value().toString();
    }
}
