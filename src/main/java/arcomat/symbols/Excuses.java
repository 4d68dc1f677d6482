package arcomat.symbols;

import java.util.List;

/** Leaves out problems that only follow from another one. */
final class Excuses {
    private Excuses() {}

    /** The value without complaints about names that an expected type might have explained. */
    static ItemValue withoutUnknownNames(ItemValue value) {
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

    /** Only the expression itself can be a bare constant of the expected type. */
    static Typed withoutUnknownNames(Typed typed) {
        if (!(typed.expression() instanceof TypedExpression.Erroneous)) {
            return typed;
        }
        List<ExpressionProblem> others =
                typed.problems().stream()
                        .filter(p -> p.kind() != ExpressionProblem.Kind.UNKNOWN_NAME)
                        .toList();
        return new Typed(typed.expression(), others);
    }
}
