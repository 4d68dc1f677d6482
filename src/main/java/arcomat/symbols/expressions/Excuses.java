package arcomat.symbols.expressions;

import arcomat.tree.Expression;

import java.util.List;

/** Leaves out problems that only follow from another one. */
public final class Excuses {
    private Excuses() {}

    /** The value without complaints about names that an expected type might have explained. */
    public static ItemValue withoutUnknownNames(ItemValue value) {
        if (value instanceof ItemValue.Alternatives alternatives) {
            return new ItemValue.Alternatives(
                    alternatives.node(),
                    alternatives.values().stream().map(Excuses::withoutUnknownNames).toList());
        }
        if (value instanceof ItemValue.Sequence sequence) {
            return new ItemValue.Sequence(
                    sequence.node(),
                    sequence.expressions().stream().map(Excuses::withoutUnknownNames).toList());
        }
        if (value instanceof ItemValue.Single single) {
            return new ItemValue.Single(single.node(), withoutUnknownNames(single.expression()));
        }
        return value;
    }

    public static Typed withoutUnknownNames(Typed typed) {
        return isUnknownBareName(typed) ? new Typed(typed.expression(), List.of()) : typed;
    }

    /** Whether an expression is a simple name that nothing has: perhaps a constant of some enum. */
    public static boolean isUnknownBareName(Typed typed) {
        return typed.expression() instanceof TypedExpression.Erroneous
                && typed.expression().node() instanceof Expression.Reference reference
                && reference.name().isSimple();
    }
}
