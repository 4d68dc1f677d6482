package arcomat.check.behaviour.item;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ValueSymbol;

import java.util.List;
import java.util.Optional;

/** ARC0318: where the name is left out, exactly one port or variable fits. (Wor16 AR5) */
public final class OmittedNameUnique implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.hasName()) {
            return;
        }
        Optional<MisplacedCondition> condition = MisplacedCondition.in(item);
        if (item.target().isUnknown() && condition.isPresent()) {
            findings.report(
                    item.node(),
                    "no %s port or variable takes '%s'; a condition stands in [..]",
                    side(item),
                    text(item));
            condition.get().fix(context).ifPresent(findings::fix);
        } else if (item.target().isUnknown()) {
            findings.report(
                    item.node(),
                    "no %s port or variable takes '%s'; correct the message, or write the name that"
                            + " is meant before it",
                    side(item),
                    text(item));
        } else if (item.target().isAmbiguous()) {
            reportAmbiguous(item, item.target().candidates(), findings);
        }
    }

    private static void reportAmbiguous(
            ItemSymbol item, List<ValueSymbol> candidates, Findings findings) {
        List<String> names = candidates.stream().map(ValueSymbol::name).toList();
        String relation = item.side() == ItemSymbol.Side.INPUT ? " == " : " = ";
        findings.report(
                item.node(),
                "'%s' could be meant for %s; write the name before it, as in '%s'",
                text(item),
                Wording.quoted(names),
                example(candidates, relation, text(item)));
        for (ValueSymbol candidate : candidates) {
            findings.related(candidate.nameSpan(), "could be meant");
        }
    }

    /** A port in the place of a message: nobody means to compare it with itself. */
    private static String example(List<ValueSymbol> candidates, String relation, String message) {
        ValueSymbol meant =
                candidates.stream()
                        .filter(each -> each.name().equals(message))
                        .findFirst()
                        .orElse(candidates.get(0));
        String fitting = meant.type().isBoolean() ? "true" : "..";
        return meant.name() + relation + (meant.name().equals(message) ? fitting : message);
    }

    private static String side(ItemSymbol item) {
        return item.side() == ItemSymbol.Side.INPUT ? "input" : "output";
    }

    private static String text(ItemSymbol item) {
        return Wording.shortened(item.node().value());
    }
}
