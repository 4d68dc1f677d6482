package arcomat.semantics.expression;

import arcomat.model.Expression;

/** Takes a condition apart into what its connectives join. */
abstract class ConditionWalk {
    /** Walks over a condition. */
    public final void condition(Expression e) {
        if (e instanceof Expression.PortMatches matches) {
            matches(matches);
        } else if (e instanceof Expression.IsIn isIn) {
            isIn(isIn);
        } else if (e instanceof Expression.Binary binary) {
            binary(binary);
        } else if (e instanceof Expression.Unary || e instanceof Expression.Conditional) {
            e.operands().forEach(this::condition);
        } else {
            value(e);
        }
    }

    private void binary(Expression.Binary binary) {
        switch (binary.operator()) {
            case AND, OR, IMPLIES -> binary.operands().forEach(this::condition);
            case EQUAL, NOT_EQUAL -> comparison(binary, false);
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL -> comparison(binary, true);
            default -> value(binary);
        }
    }

    abstract void matches(Expression.PortMatches matches);

    abstract void isIn(Expression.IsIn isIn);

    /**
     * @param ordered whether it matters which one is less
     */
    abstract void comparison(Expression.Binary binary, boolean ordered);

    /** Anything else that is true or false. */
    abstract void value(Expression e);
}
