package arcomat.check.behaviour.action;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.tree.Expression;

import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * ARC0345: a value that has to be written out, with names standing for what was assigned to them,
 * has a size that everybody can look at. That is what may go wrong or read a silent port, since it
 * is not computed before it is certain that it is needed, and all that comes before the first
 * slice.
 */
public final class ActionsBounded implements Check.OnActions {
    /** Names, literals and operators of one value, where names stand for what was assigned. */
    private static final long LARGEST = 2_000;

    /** Beyond it, it does not matter how far. */
    private static final long TOO_MUCH = 1_000_000;

    @Override
    public void check(ActionSymbol actions, Context context, Findings findings) {
        boolean initial = context.side().equals(Optional.of(Side.INITIAL));
        actions.match(new Sizes(findings, initial));
    }

    /** How large values become at most, whichever way is taken. */
    private static final class Sizes implements ActionSymbol.Cases<Boolean> {
        private final Findings findings;
        private final boolean all;
        private Map<ValueSymbol, Long> sizes = new HashMap<>();

        /**
         * @param all whether all values are written out
         */
        Sizes(Findings findings, boolean all) {
            this.findings = findings;
            this.all = all;
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
            Map<ValueSymbol, Long> before = sizes;
            sizes = new HashMap<>(before);
            boolean small = choice.then().match(this);
            Map<ValueSymbol, Long> then = sizes;
            sizes = new HashMap<>(before);
            small &= choice.otherwise().map(each -> each.match(this)).orElse(true);
            join(before, then);
            return small;
        }

        /** A value that one of two ways changes says which of them was gone. */
        private void join(Map<ValueSymbol, Long> before, Map<ValueSymbol, Long> then) {
            Set<ValueSymbol> names = new HashSet<>(then.keySet());
            names.addAll(sizes.keySet());
            for (ValueSymbol name : names) {
                Long first = then.get(name);
                Long second = sizes.get(name);
                Long unchanged = before.get(name);
                if (first == null && second == null) {
                    sizes.remove(name);
                } else if (!Objects.equals(first, unchanged)
                        || !Objects.equals(second, unchanged)) {
                    long both = 1 + or1(first) + or1(second);
                    sizes.put(name, Math.min(TOO_MUCH, both));
                }
            }
        }

        private static long or1(@Nullable Long size) {
            return size == null ? 1 : size;
        }

        @Override
        public Boolean assign(ActionSymbol.Assign assign) {
            ItemSymbol item = assign.item();
            for (Typed each : item.value().expressions()) {
                if (!isSmall(each)) {
                    return false;
                }
                item.target().found().ifPresent(target -> put(target, each));
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
                    put(local.variable(), initial);
                }
            }
            return true;
        }

        private void put(ValueSymbol name, Typed value) {
            if (isWrittenOut(value)) {
                sizes.put(name, size(value));
            } else {
                sizes.remove(name);
            }
        }

        /** Whether a value is not computed where it is assigned. */
        private boolean isWrittenOut(Typed value) {
            boolean[] unsure = {all};
            value.expression().walk(part -> unsure[0] |= isUnsure(part));
            return unsure[0];
        }

        private boolean isUnsure(TypedExpression part) {
            if (part instanceof TypedExpression.VariableRead read) {
                return sizes.containsKey(read.variable());
            }
            return part instanceof TypedExpression.PortRead read && !read.port().isTotal()
                    || part.node() instanceof Expression.Binary binary
                            && binary.operator().divides();
        }

        private boolean isSmall(Typed value) {
            long size = size(value);
            if (size > LARGEST) {
                findings.report(
                        value.expression().node(),
                        "written out with what was assigned before, this value has %s parts, and at"
                                + " most %s are looked at%s",
                        size >= TOO_MUCH ? "far too many" : size,
                        LARGEST,
                        all
                                ? " before the first slice; compute it in a transition"
                                : " where something may go wrong or be missing; keep something in"
                                        + " between in a variable of the automaton, and go on in"
                                        + " the next step");
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
