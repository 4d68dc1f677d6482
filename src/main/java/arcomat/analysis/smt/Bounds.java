package arcomat.analysis.smt;

import arcomat.analysis.smt.Question.Beyond;
import arcomat.analysis.smt.Question.Parity;
import arcomat.model.Automaton;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.Start;
import arcomat.semantics.automaton.StepRelation;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * What counters often keep to: they never fall below zero or what they begin with, or never rise
 * above it; or they stay even or odd, even where they wrap around. Nobody asked whether they do;
 * but induction, which begins anywhere, proves more once it knows.
 */
final class Bounds {
    private Bounds() {}

    static Set<Question> candidates(StepRelation relation) {
        Automaton automaton = relation.automaton();
        Set<Question> candidates = new LinkedHashSet<>();
        for (int variable = 0; variable < automaton.variables().size(); variable++) {
            boolean unbounded =
                    automaton.variables().get(variable).type() instanceof Type.IntegerType integer
                            && !integer.ranged();
            if (unbounded) {
                addTo(candidates, variable, relation.starts());
            }
        }
        return candidates;
    }

    private static void addTo(Set<Question> candidates, int variable, List<Start> starts) {
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
