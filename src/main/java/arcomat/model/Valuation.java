package arcomat.model;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * How a condition comes to be true, false or undefined by Kleene's rules, part by part: each part
 * stands in it once, however deeply it is nested.
 */
public sealed interface Valuation {
    /** Takes it apart, from the parts on, from left to right. */
    <R> R fold(Cases<R> cases);

    /**
     * What becomes of each form, once it is known what becomes of what it is made of.
     *
     * @param <R> what is made
     */
    interface Cases<R> {
        R part(Part part);

        R not(R operand);

        R row(boolean all, R left, R right);

        R comparison(boolean equal, R left, R right);

        R choice(R condition, R then, R otherwise);
    }

    /**
     * A condition that is not taken apart.
     *
     * @param defined two-valued, whether it has a value
     * @param value which one; looked at where it has one only
     */
    record Part(Expression defined, Expression value) implements Valuation {
        @Override
        public <R> R fold(Cases<R> cases) {
            return cases.part(this);
        }
    }

    record Not(Valuation operand) implements Valuation {
        @Override
        public <R> R fold(Cases<R> cases) {
            return cases.not(operand.fold(cases));
        }
    }

    /** Both hold, or at least one does. */
    record Row(boolean all, Valuation left, Valuation right) implements Valuation {
        @Override
        public <R> R fold(Cases<R> cases) {
            R first = left.fold(cases);
            return cases.row(all, first, right.fold(cases));
        }
    }

    /** Both have the same value, or they have different ones. */
    record Comparison(boolean equal, Valuation left, Valuation right) implements Valuation {
        @Override
        public <R> R fold(Cases<R> cases) {
            R first = left.fold(cases);
            return cases.comparison(equal, first, right.fold(cases));
        }
    }

    record Choice(Valuation condition, Valuation then, Valuation otherwise) implements Valuation {
        @Override
        public <R> R fold(Cases<R> cases) {
            R decides = condition.fold(cases);
            R first = then.fold(cases);
            return cases.choice(decides, first, otherwise.fold(cases));
        }
    }

    /** Its parts, two expressions each, from left to right. */
    default List<Expression> expressions() {
        List<Expression> all = new ArrayList<>();
        with(
                each -> {
                    all.add(each);
                    return each;
                });
        return all;
    }

    /** The same of other parts. */
    default Valuation with(Function<Expression, Expression> rewrite) {
        return fold(
                new Cases<>() {
                    @Override
                    public Valuation part(Part part) {
                        Expression defined = rewrite.apply(part.defined());
                        return new Part(defined, rewrite.apply(part.value()));
                    }

                    @Override
                    public Valuation not(Valuation operand) {
                        return new Not(operand);
                    }

                    @Override
                    public Valuation row(boolean all, Valuation left, Valuation right) {
                        return new Row(all, left, right);
                    }

                    @Override
                    public Valuation comparison(boolean equal, Valuation left, Valuation right) {
                        return new Comparison(equal, left, right);
                    }

                    @Override
                    public Valuation choice(
                            Valuation condition, Valuation then, Valuation otherwise) {
                        return new Choice(condition, then, otherwise);
                    }
                });
    }
}
