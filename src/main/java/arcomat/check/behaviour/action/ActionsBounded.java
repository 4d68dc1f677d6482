package arcomat.check.behaviour.action;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.symbols.expressions.ValueSymbol;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * ARC0345: what is computed before the first slice, with names written out as what was assigned to
 * them, is of such a size that everybody can look at it.
 */
public final class ActionsBounded implements Check.OnActions {
    /** Names, literals and operators of one value, where names stand for what was assigned. */
    private static final long LARGEST = 2_000;

    /** Beyond it, it does not matter how far. */
    private static final long TOO_MUCH = 1_000_000;

    @Override
    public void check(ActionSymbol actions, Context context, Findings findings) {
        if (context.side().equals(Optional.of(Side.INITIAL))) {
            actions.match(new Sizes(findings));
        }
    }

    /** How large values become at most, whichever way is taken. */
    private static final class Sizes implements ActionSymbol.Cases<Boolean> {
        private final Findings findings;
        private Map<ValueSymbol, Long> sizes = new HashMap<>();

        Sizes(Findings findings) {
            this.findings = findings;
        }

        @Override
        public Boolean sequence(ActionSymbol.Sequence sequence) {
            return sequence.actions().stream().allMatch(each -> each.match(this));
        }

        @Override
        public Boolean choose(ActionSymbol.Choose choice) {
            if (!isSmall(choice.condition())) {
                return false;
            }
            Map<ValueSymbol, Long> before = new HashMap<>(sizes);
            boolean small = choice.then().match(this);
            Map<ValueSymbol, Long> then = sizes;
            sizes = before;
            small &= choice.otherwise().map(each -> each.match(this)).orElse(true);
            then.forEach((name, size) -> sizes.merge(name, size, Math::max));
            return small;
        }

        @Override
        public Boolean assign(ActionSymbol.Assign assign) {
            ItemSymbol item = assign.item();
            for (Typed each : item.value().expressions()) {
                if (!isSmall(each)) {
                    return false;
                }
                item.target().found().ifPresent(target -> sizes.put(target, size(each)));
            }
            return true;
        }

        @Override
        public Boolean declare(ActionSymbol.Declare declare) {
            for (ActionSymbol.Local local : declare.locals()) {
                Typed initial = local.variable().initial().orElse(null);
                if (initial != null) {
                    if (!isSmall(initial)) {
                        return false;
                    }
                    sizes.put(local.variable(), size(initial));
                }
            }
            return true;
        }

        private boolean isSmall(Typed value) {
            long size = size(value);
            if (size > LARGEST) {
                findings.report(
                        value.expression().node(),
                        "written out with what was assigned before, this value has %s parts, and"
                                + " before the first slice at most %s are looked at; compute it in"
                                + " a transition",
                        size >= TOO_MUCH ? "far too many" : size,
                        LARGEST);
            }
            return size <= LARGEST;
        }

        private long size(Typed value) {
            return value.size(this::sizeOfPart, TOO_MUCH);
        }

        private long sizeOfPart(TypedExpression part) {
            return part instanceof TypedExpression.VariableRead read
                    ? sizes.getOrDefault(read.variable(), 1L)
                    : 1;
        }
    }
}
