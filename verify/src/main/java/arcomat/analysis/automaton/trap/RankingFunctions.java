package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.induction.Move;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Expression;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * What may come closer to an end in some states: each variable that changes there, and differences
 * that guards look at.
 */
record RankingFunctions(Subject subject, List<Move> moves) {
    private static final int MOST = 8;

    List<RankingFunction> of(Set<Integer> states) {
        Set<Expression> numbers = new LinkedHashSet<>();
        for (Variable each : subject.automaton().variables()) {
            if (each.type().isNumber() && changes(each, states)) {
                numbers.add(new Expression.VariableRead(each, each.span()));
            }
        }
        for (Move move : moves) {
            if (states.contains(move.source())) {
                differences(move.goesOn(), numbers);
            }
        }
        List<RankingFunction> measures = new ArrayList<>();
        numbers.stream()
                .limit(MOST)
                .forEach(
                        each -> {
                            measures.add(new RankingFunction(each, true));
                            measures.add(new RankingFunction(each, false));
                        });
        return measures;
    }

    private boolean changes(Variable variable, Set<Integer> states) {
        return moves.stream()
                .anyMatch(
                        move ->
                                states.contains(move.source())
                                        && move.assigned().containsKey(variable.name()));
    }

    private static void differences(Expression condition, Set<Expression> numbers) {
        condition.visit(
                part -> {
                    if (part instanceof Expression.Binary binary
                            && binary.left() instanceof Expression.VariableRead left
                            && binary.right() instanceof Expression.VariableRead right
                            && left.type().isNumber()
                            && left.type().equals(right.type())) {
                        numbers.add(Sums.difference(left, right));
                    }
                });
    }
}
