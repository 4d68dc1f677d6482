package arcomat.check.behaviour.total;

import arcomat.check.behaviour.item.Items;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.tree.Node;

/** ARC0338: nobody waits for silence on an input that carries a message in every slice. */
public final class TotalInputNeverSilent implements Check.OnItem, Check.OnExpression {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.side() == ItemSymbol.Side.INPUT) {
            Items.port(item).ifPresent(port -> check(item.value(), port, findings));
        }
    }

    @Override
    public void check(Typed expression, Context context, Findings findings) {
        expression
                .expression()
                .walk(
                        part -> {
                            if (part instanceof TypedExpression.Absence absence) {
                                check(absence.node(), absence.port(), findings);
                            }
                        });
    }

    private static void check(ItemValue value, PortSymbol port, Findings findings) {
        for (ItemValue part : Items.parts(value)) {
            if (Items.isSilence(part)) {
                check(part.node(), port, findings);
            }
        }
    }

    private static void check(Node place, PortSymbol port, Findings findings) {
        if (port.isInput() && port.isTotal()) {
            findings.report(
                            place,
                            "'%s' is never silent (<<total>>); remove this, or the stereotype",
                            port.name())
                    .related(port.nameSpan(), "declared <<total>>");
        }
    }
}
