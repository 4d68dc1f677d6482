package arcomat.analysis.smt;

import arcomat.analysis.smt.Unrolling.StatePredicate;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.StepRelation.Start;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Candidates of auxiliary invariants. What counters often keep to: they never fall below zero or
 * what they begin with, or never rise above it; or they stay even or odd, even where they wrap
 * around. Nobody asked whether they do; but induction, which begins anywhere, proves more once it
 * knows.
 */
final class Bounds {
    private Bounds() {}

    /** An integer variable is odd, or even. */
    private record Parity(int variable, boolean odd) implements StatePredicate {
        @Override
        public Term at(SymbolicTransitions there) {
            return there.parity(variable, odd);
        }
    }

    /** An integer variable is below a bound, or above it. */
    private record Beyond(int variable, boolean below, long bound) implements StatePredicate {
        @Override
        public Term at(SymbolicTransitions there) {
            return there.beyond(variable, below, bound);
        }
    }

    /** Each is what a run might show to break the bound. */
    static Set<StatePredicate> candidates(Subject subject) {
        List<Start> starts = subject.relation().starts();
        Set<StatePredicate> candidates = new LinkedHashSet<>();
        for (int variable = 0; variable < subject.automaton().variables().size(); variable++) {
            Type type = subject.automaton().variables().get(variable).type();
            if (type instanceof Type.IntegerType integer && !integer.ranged()) {
                addTo(candidates, variable, starts);
            }
        }
        return candidates;
    }

    private static void addTo(Set<StatePredicate> candidates, int variable, List<Start> starts) {
        for (long bound : new long[] {0, value(starts.get(0), variable)}) {
            if (starts.stream().allMatch(start -> value(start, variable) >= bound)) {
                candidates.add(new Beyond(variable, true, bound));
            }
            if (starts.stream().allMatch(start -> value(start, variable) <= bound)) {
                candidates.add(new Beyond(variable, false, bound));
            }
        }
        boolean odd = isOdd(starts.get(0), variable);
        if (starts.stream().allMatch(start -> isOdd(start, variable) == odd)) {
            candidates.add(new Parity(variable, !odd));
        }
    }

    private static boolean isOdd(Start start, int variable) {
        return value(start, variable) % 2 != 0;
    }

    private static long value(Start start, int variable) {
        Value value = start.configuration().variables().get(variable);
        return ((Value.IntegerValue) value).value();
    }
}
