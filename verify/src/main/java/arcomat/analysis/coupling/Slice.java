package arcomat.analysis.coupling;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.PartialEvaluation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/**
 * All that may happen in a pair of states with messages on certain ports.
 *
 * @param mine what the left side may do
 * @param theirs what the right side may do
 * @param errs when a run of the left side ends, and one of the right side cannot
 * @param ports what all of this reads: inputs with a message, and variables
 */
record Slice(
        StatePair pair,
        List<PossibleStep> mine,
        List<PossibleStep> theirs,
        Expression errs,
        List<Port> ports) {

    /**
     * @param messages names of the ports that carry one
     * @param conditions their variables count as read
     */
    static Slice of(
            Coupling coupling, StatePair pair, Set<String> messages, List<Port> conditions) {
        List<String> open =
                Stream.concat(messages.stream(), coupling.memory.stream().map(Port::name)).toList();
        PartialEvaluation known = new PartialEvaluation(Map.of(), Set.copyOf(open));
        List<PossibleStep> mine = with(known, coupling.left.behaviours(pair.left()));
        List<PossibleStep> theirs = with(known, coupling.right.behaviours(pair.right()));
        Expression errs =
                known.of(
                        Formulas.and(
                                coupling.left.errs(pair.left()),
                                Formulas.not(coupling.right.errs(pair.right()))));
        List<Expression> all = new ArrayList<>(List.of(errs));
        mine.forEach(each -> all.addAll(each.expressions()));
        theirs.forEach(each -> all.addAll(each.expressions()));
        return new Slice(pair, mine, theirs, errs, ports(all, conditions));
    }

    private static List<PossibleStep> with(PartialEvaluation known, List<PossibleStep> behaviours) {
        return behaviours.stream().map(each -> each.with(known::of)).toList();
    }

    private static List<Port> ports(List<Expression> read, List<Port> others) {
        Map<String, Port> ports = new LinkedHashMap<>();
        read.stream()
                .flatMap(each -> each.ports().stream())
                .forEach(port -> ports.putIfAbsent(port.name(), port));
        others.forEach(port -> ports.putIfAbsent(port.name(), port));
        return List.copyOf(ports.values());
    }

    /** The pair after a step of both. */
    static StatePair after(PossibleStep mine, PossibleStep theirs) {
        return new StatePair(mine.target(), theirs.target());
    }

    /** A comparison of what variables are after a step of both, about what was before. */
    static Claim after(Comparison comparison, PossibleStep mine, PossibleStep theirs) {
        return comparison
                .claim()
                .rewritten(
                        leaf ->
                                leaf instanceof Expression.PortRead read
                                        ? value(read, mine, theirs)
                                        : leaf);
    }

    /** What a variable is after a step of both. */
    static Expression value(Expression.PortRead variable, PossibleStep mine, PossibleStep theirs) {
        String name = variable.port().name();
        return mine.after().getOrDefault(name, theirs.after().getOrDefault(name, variable));
    }
}
