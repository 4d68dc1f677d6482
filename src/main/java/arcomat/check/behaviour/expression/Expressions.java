package arcomat.check.behaviour.expression;

import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.tree.Node;

import java.util.function.BiConsumer;

/** What several laws about expressions share. */
final class Expressions {
    private Expressions() {}

    /** Shows the ports that an expression reads, or whose silence it asks for, and where. */
    static void portsRead(Typed typed, BiConsumer<Node, PortSymbol> visitor) {
        typed.expression()
                .walk(
                        part -> {
                            if (part instanceof TypedExpression.PortRead read) {
                                visitor.accept(read.node(), read.port());
                            } else if (part instanceof TypedExpression.Absence absence) {
                                visitor.accept(absence.node(), absence.port());
                            }
                        });
    }
}
