package arcomat.analysis.smt;

import arcomat.analysis.smt.Question.Beyond;
import arcomat.model.Automaton;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.Start;
import arcomat.semantics.StepRelation;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Bounds that counters often keep: they never fall below zero or what they begin with, or never
 * rise above it. Nobody asked whether they do; but induction, which begins anywhere, proves more
 * once it knows.
 */
final class Bounds {
    private Bounds() {}

    static Set<Beyond> candidates(StepRelation relation) {
        Automaton automaton = relation.automaton();
        Set<Beyond> candidates = new LinkedHashSet<>();
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

    private static void addTo(Set<Beyond> candidates, int variable, List<Start> starts) {
        for (long bound : new long[] {0, value(starts.get(0), variable)}) {
            if (starts.stream().allMatch(start -> value(start, variable) >= bound)) {
                candidates.add(new Beyond(variable, true, bound));
            }
            if (starts.stream().allMatch(start -> value(start, variable) <= bound)) {
                candidates.add(new Beyond(variable, false, bound));
            }
        }
    }

    private static long value(Start start, int variable) {
        Value value = start.configuration().variables().get(variable);
        return ((Value.IntegerValue) value).value();
    }
}
