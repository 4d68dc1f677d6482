package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** What the input side asks of a port: that one of the patterns matches. */
record InputCondition(Port port, List<Automaton.Pattern> patterns, Span span) {
    InputCondition {
        patterns = List.copyOf(patterns);
    }

    /** As a match, if one pattern says it all. */
    Optional<Automaton.Match> match() {
        return patterns.size() == 1
                ? Optional.of(new Automaton.Match(port, patterns.get(0)))
                : Optional.empty();
    }

    /** As a guard that is always defined. */
    Expression guard() {
        return Connectives.disjunction(
                patterns.stream()
                        .<Expression>map(p -> new Expression.PortMatches(port, p, span))
                        .toList());
    }

    /** Whether the same letter can never satisfy both, as far as constants tell. */
    boolean excludes(InputCondition other) {
        return port.name().equals(other.port.name())
                && patterns.stream()
                        .allMatch(p -> other.patterns.stream().allMatch(q -> areDisjoint(p, q)));
    }

    private static boolean areDisjoint(Automaton.Pattern p, Automaton.Pattern q) {
        boolean absentHere = p instanceof Automaton.Absent;
        boolean absentThere = q instanceof Automaton.Absent;
        if (absentHere || absentThere) {
            return absentHere != absentThere;
        }
        return p instanceof Automaton.OneOf here
                && q instanceof Automaton.OneOf there
                && here.values().stream()
                        .allMatch(v -> there.values().stream().allMatch(w -> differ(v, w)));
    }

    private static boolean differ(Expression a, Expression b) {
        return a instanceof Expression.Constant x
                && b instanceof Expression.Constant y
                && !x.value().equals(y.value());
    }
}
