package arcomat.semantics.expression;

import arcomat.model.Expression;

/** Takes a condition apart into what its connectives join. */
abstract class ConditionWalk {
    private final Forms forms = new Forms();

    /** Walks over a condition. */
    public final void condition(Expression e) {
        e.match(forms).run();
    }

    private final class Forms implements Expression.SomeCases<Runnable> {
        @Override
        public Runnable portMatches(Expression.PortMatches portMatches) {
            return () -> matches(portMatches);
        }

        @Override
        public Runnable isIn(Expression.IsIn isIn) {
            return () -> ConditionWalk.this.isIn(isIn);
        }

        @Override
        public Runnable binary(Expression.Binary binary) {
            return () -> ConditionWalk.this.binary(binary);
        }

        @Override
        public Runnable unary(Expression.Unary unary) {
            return () -> condition(unary.operand());
        }

        @Override
        public Runnable conditional(Expression.Conditional conditional) {
            return () -> conditional.operands().forEach(ConditionWalk.this::condition);
        }

        @Override
        public Runnable judged(Expression.Judged judged) {
            return () -> judged.operands().forEach(ConditionWalk.this::condition);
        }

        @Override
        public Runnable otherwise(Expression e) {
            return () -> value(e);
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
