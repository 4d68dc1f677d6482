package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.ValueSymbol;

import java.util.Optional;

/**
 * ARC0350: a message is not a condition about an input port. {@code {stop == false && light < 40}}
 * waits for the message {@code false && light < 40}; what is meant is a guard. A condition in
 * parentheses is a message.
 */
public final class NoConditionAsMessage implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        Optional<ValueSymbol> target = item.target().found();
        boolean takesConditions =
                item.side() != Side.INPUT
                        && target.filter(each -> each.type().isBoolean()).isPresent();
        if (target.isPresent() && !takesConditions) {
            MisplacedCondition.in(item)
                    .ifPresent(found -> report(found, target.get(), context, findings));
        }
    }

    private static void report(
            MisplacedCondition condition, ValueSymbol target, Context context, Findings findings) {
        findings.report(
                condition.item().node(),
                "this is read as the message '%s' for '%s'; write a condition in [..]%s",
                condition.messageText(),
                target.name(),
                target.type().isBoolean() ? ", or put the message in parentheses" : "");
        condition.fix(context).ifPresent(findings::fix);
    }
}
