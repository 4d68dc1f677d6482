package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.symbols.names.BuiltinType;
import arcomat.tree.Expression.UnaryOperator;

import java.util.Optional;

/**
 * ARC0337: an input item compares a port with something else. {@code {tick}} looks like a condition
 * but waits for a message that equals itself: every message does.
 */
public final class ComparedWithItself implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        Optional<PortSymbol> port = Items.port(item);
        if (item.side() == ItemSymbol.Side.INPUT
                && port.isPresent()
                && !isReal(port.get())
                && item.value() instanceof ItemValue.Single single) {
            TypedExpression value = single.expression().expression();
            if (reads(value, port.get())) {
                reportAlways(item, port.get(), findings);
            } else if (isNegation(value) && reads(value.parts().get(0), port.get())) {
                reportNever(item, port.get().name(), findings);
            }
        }
    }

    /** {@code NaN} does not equal itself: there, it is a question to be asked. */
    private static boolean isReal(PortSymbol port) {
        return port.type().base() instanceof BuiltinType type && type.isReal();
    }

    private static boolean reads(TypedExpression value, PortSymbol port) {
        return value instanceof TypedExpression.PortRead read && read.port().equals(port);
    }

    private static boolean isNegation(TypedExpression value) {
        return value instanceof TypedExpression.Unary unary
                && unary.node().operator() == UnaryOperator.NOT;
    }

    private static void reportAlways(ItemSymbol item, PortSymbol port, Findings findings) {
        String name = port.name();
        String same = "this compares '" + name + "' with itself, so every message fits; write '";
        String any = name + " == ?";
        if (port.type().isBoolean()) {
            String meant = name + " == true";
            findings.report(
                    item.node(), same + meant + "', or '" + any + "' if any message is meant");
            fix(item, meant, findings);
        } else {
            findings.report(item.node(), same + any + "' if any message is meant");
            fix(item, any, findings);
        }
    }

    private static void reportNever(ItemSymbol item, String name, Findings findings) {
        String meant = name + " == false";
        findings.report(
                item.node(),
                "this compares '%s' with its own negation, so no message fits; write '%s'",
                name,
                meant);
        fix(item, meant, findings);
    }

    private static void fix(ItemSymbol item, String meant, Findings findings) {
        findings.fix(Fix.replace("Change to '" + meant + "'", item.node().span(), meant));
    }
}
