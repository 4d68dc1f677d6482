package arcomat.analysis.reachability;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.automaton.StepRelation.Start;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.LongPredicate;

/**
 * Candidates of auxiliary invariants. What counters often keep to: they never fall below zero or
 * what they begin with, or never rise above it; or they stay even or odd, even where they wrap
 * around. Nobody asked whether they do; but induction, which begins anywhere, proves more once it
 * knows.
 */
public final class Bounds {
    private final Subject subject;

    /** Each is what a run might show to break a bound. */
    private final Set<Expression> candidates = new LinkedHashSet<>();

    private Bounds(Subject subject) {
        this.subject = subject;
    }

    /** Each is what a run might show to break the bound. */
    public static Set<Expression> candidates(Subject subject) {
        Bounds bounds = new Bounds(subject);
        for (int i = 0; i < subject.automaton().variables().size(); i++) {
            Variable variable = subject.automaton().variables().get(i);
            if (variable.type() instanceof Type.IntegerType integer && !integer.ranged()) {
                bounds.add(variable, bounds.initial(i));
            }
        }
        return bounds.candidates;
    }

    private List<Long> initial(int variable) {
        return subject.relation().starts().stream().map(start -> value(start, variable)).toList();
    }

    private static long value(Start start, int variable) {
        Value value = start.configuration().variables().get(variable);
        return ((Value.IntegerValue) value).value();
    }

    private void add(Variable variable, List<Long> initial) {
        Expression read = new Expression.VariableRead(variable, variable.span());
        long first = initial.get(0);
        for (long bound : first == 0 ? new long[] {0} : new long[] {0, first}) {
            Expression number = Hazard.number(bound, read);
            if (are(initial, value -> value >= bound)) {
                candidates.add(Hazard.compare(BinaryOperator.LESS, read, number));
            }
            if (are(initial, value -> value <= bound)) {
                candidates.add(Hazard.compare(BinaryOperator.GREATER, read, number));
            }
        }
        boolean odd = first % 2 != 0;
        if (are(initial, value -> odd == (value % 2 != 0))) {
            candidates.add(parity(read, !odd));
        }
    }

    private static boolean are(List<Long> initial, LongPredicate condition) {
        return initial.stream().allMatch(condition::test);
    }

    /** It is odd, or even. */
    private static Expression parity(Expression read, boolean odd) {
        Expression rest =
                new Expression.Binary(
                        BinaryOperator.REMAINDER,
                        read,
                        Hazard.number(2, read),
                        read.type(),
                        read.span());
        return Hazard.compare(
                odd ? BinaryOperator.NOT_EQUAL : BinaryOperator.EQUAL,
                rest,
                Hazard.number(0, read));
    }
}
