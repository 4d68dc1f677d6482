package arcomat.semantics.expression;

import static arcomat.semantics.expression.Formulas.FALSE;
import static arcomat.semantics.expression.Formulas.TRUE;
import static arcomat.semantics.expression.Formulas.and;
import static arcomat.semantics.expression.Formulas.not;
import static arcomat.semantics.expression.Formulas.or;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.ExpressionText;
import arcomat.model.Type;
import arcomat.semantics.value.TooManyWays;

import java.util.ArrayList;
import java.util.List;

/**
 * Turns Kleene's three values into Java's two. An expression that reads an absent port is
 * undefined, and a transition needs its guard to be true for certain; the conditions made here are
 * always defined and say just that. Interpreter and generated code evaluate these conditions and
 * nothing else, from left to right with {@code &&} and {@code ||} as in Java, so that they cannot
 * differ. Where such a condition would be much longer than the guard, both {@linkplain
 * Expression.Judged judge} the guard part by part, by the same functions.
 *
 * <p>Two-valued conditions read a port only where an {@link Expression.PortMatches} on their left
 * has found a message on it. Ports that always carry one ({@code <<total>>}) need no such test.
 */
public final class Guards {
    /** How many parts a condition may have that stays as a person would write it. */
    private static final long LONGEST = 5_000;

    /** How many parts it may have in any case where conditions may be judged. */
    private static final long SHORT = 500;

    /** How many parts a longer one may have for each that is written. */
    private static final long PARTS_PER_PART = 8;

    private final Formulas formulas;
    private final TwoValued plain;
    private final TwoValued once;
    private final long longest;
    private final boolean judges;

    public Guards(Component.Profile profile) {
        this(profile, LONGEST, false);
    }

    /**
     * Conditions that grow only as the guards do: what nests so that it would stand in a condition
     * many times is {@linkplain Expression.Judged judged}.
     */
    public static Guards judging(Component.Profile profile) {
        return new Guards(profile, LONGEST, true);
    }

    /**
     * @param longest of how many parts a condition is made as a person would write it
     */
    Guards(Component.Profile profile, long longest, boolean judges) {
        this.longest = longest;
        this.judges = judges;
        formulas = new Formulas(profile);
        plain = new TwoValued(formulas, false);
        once = new TwoValued(formulas, true);
    }

    /**
     * When a transition out of the present state may be taken: what it asks is so, and none that
     * comes before it could be taken.
     */
    public Expression enabledWhen(Automaton automaton, Automaton.Transition transition) {
        Expression condition = asked(transition);
        for (Automaton.Transition each : automaton.before(transition)) {
            condition = and(condition, not(asked(each)));
        }
        return formulas.simplify(condition);
    }

    /**
     * What a transition asks by its input block, its guard, and what it reads.
     *
     * @throws TooManyWays where statements ask it that cannot be said as one condition
     */
    public Expression asked(Automaton.Transition transition) {
        if (transition.isWhole()) {
            throw new TooManyWays();
        }
        Expression condition = TRUE;
        for (Automaton.Match match : transition.matches()) {
            condition = and(condition, fits(matches(match, transition)));
        }
        if (transition.guard().isPresent()) {
            condition = and(condition, isTrue(transition.guard().get()));
        }
        for (Automaton.Send send : transition.sends()) {
            for (Expression value : send.emission().values()) {
                condition = and(condition, formulas.present(value));
            }
        }
        for (Automaton.Assignment assignment : transition.assignments()) {
            condition = and(condition, formulas.present(assignment.value()));
        }
        return formulas.simplify(condition);
    }

    private static Expression matches(Automaton.Match match, Automaton.Transition transition) {
        return new Expression.PortMatches(match.port(), match.pattern(), transition.span());
    }

    private Expression fits(Expression matches) {
        return and(formulas.present(matches), matches);
    }

    /**
     * What a transition asks, taken apart: the items of its input block, the parts of its guard
     * that have to be true together, that there is what its outputs and assignments read, and that
     * none before it could be taken. It is enabled where all of them hold, looked at from left to
     * right.
     */
    public List<Clause> clauses(Automaton automaton, Automaton.Transition transition) {
        List<Clause> clauses = new ArrayList<>(clauses(transition));
        for (Automaton.Transition each : automaton.before(transition)) {
            Expression denied = formulas.simplify(not(asked(each)));
            String text = "not before it: " + ExpressionText.of(asked(each));
            clauses.add(new Clause(denied, denied, text, false));
        }
        return clauses;
    }

    private List<Clause> clauses(Automaton.Transition transition) {
        List<Clause> clauses = new ArrayList<>();
        for (Automaton.Match match : transition.matches()) {
            Expression asked = matches(match, transition);
            clauses.add(clause(asked, fits(asked)));
        }
        transition.guard().ifPresent(guard -> addConjuncts(guard, clauses));
        for (Automaton.Send send : transition.sends()) {
            for (Expression value : send.emission().values()) {
                addReading(send.port().name(), value, clauses);
            }
        }
        for (Automaton.Assignment assignment : transition.assignments()) {
            addReading(assignment.variable().name(), assignment.value(), clauses);
        }
        if (transition.isWhole()) {
            clauses.add(new Clause(FALSE, FALSE, "a way through its statements", false));
        }
        return clauses;
    }

    private Clause clause(Expression asked, Expression condition) {
        return new Clause(asked, formulas.simplify(condition), ExpressionText.of(asked), false);
    }

    private void addConjuncts(Expression guard, List<Clause> clauses) {
        if (guard instanceof Expression.Binary both && both.operator() == BinaryOperator.AND) {
            addConjuncts(both.left(), clauses);
            addConjuncts(both.right(), clauses);
        } else {
            clauses.add(clause(guard, isTrue(guard)));
        }
    }

    /**
     * The parts of a guard that negate one of few messages, which may not be there: {@code
     * !blocked}, {@code command != stop}. Who writes that often means "else", and silence is not in
     * it. Of numbers, "another one" is what is meant.
     */
    public List<Expression> negations(Automaton.Transition transition) {
        return clauses(transition).stream()
                .map(Clause::asked)
                .filter(this::negatesMessage)
                .toList();
    }

    private boolean negatesMessage(Expression asked) {
        return Formulas.isNegation(asked)
                ? isMessage(asked.operands().get(0), BinaryOperator.EQUAL)
                : isComparison(asked, BinaryOperator.NOT_EQUAL);
    }

    private boolean isMessage(Expression e, BinaryOperator operator) {
        return formulas.mayBeUndefined(e) || isComparison(e, operator);
    }

    /** Of a message with what is no message. */
    private boolean isComparison(Expression e, BinaryOperator operator) {
        if (!(e instanceof Expression.Binary binary) || binary.operator() != operator) {
            return false;
        }
        boolean few =
                binary.left().type() instanceof Type.BooleanType
                        || binary.left().type() instanceof Type.EnumType;
        return few
                && (formulas.mayBeUndefined(binary.left()) && binary.right().ports().isEmpty()
                        || formulas.mayBeUndefined(binary.right())
                                && binary.left().ports().isEmpty());
    }

    /**
     * That all which a transition asks is so, but that some negations may have nothing to negate.
     *
     * @param negations of its {@link #negations}
     */
    public Expression enabledButForSilence(
            Automaton automaton, Automaton.Transition transition, List<Expression> negations) {
        Expression condition = TRUE;
        for (Clause clause : clauses(automaton, transition)) {
            Expression silent = not(formulas.present(clause.asked()));
            condition =
                    and(
                            condition,
                            negations.contains(clause.asked())
                                    ? or(silent, clause.condition())
                                    : clause.condition());
        }
        return condition;
    }

    /** Where a value reads nothing that may be missing, nothing is asked. */
    private void addReading(String name, Expression value, List<Clause> clauses) {
        Expression present = formulas.simplify(formulas.present(value));
        if (!present.equals(TRUE)) {
            String text = "/ {" + name + " = " + ExpressionText.of(value) + "}";
            clauses.add(new Clause(value, present, text, true));
        }
    }

    /** That a condition has a value, which is true. */
    Expression isTrue(Expression guard) {
        long parts = ConditionLength.of(guard, formulas).truth();
        if (judges && parts > SHORT && parts > PARTS_PER_PART * ConditionLength.parts(guard)) {
            return judged(guard);
        }
        boolean asksOnce = !judges && parts > longest;
        return (asksOnce ? once : plain).certainly(true, guard);
    }

    Expression judged(Expression guard) {
        return new Expression.Judged(new Judging(formulas, plain).of(guard), guard.span());
    }
}
