package arcomat.generate.text;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.stream.Stream;

/** The expressions that automata are written with. */
public final class WrittenExpressions {
    private WrittenExpressions() {}

    public static Stream<Expression> of(Automaton.Initial initial) {
        return Stream.concat(of(initial.sends()), ofAssigned(initial.assignments()));
    }

    public static Stream<Expression> of(Automaton.Transition transition) {
        Stream<Expression> asked =
                Stream.concat(
                        transition.matches().stream()
                                .flatMap(match -> match.pattern().values().stream()),
                        transition.guard().stream());
        Stream<Expression> done =
                Stream.concat(of(transition.sends()), ofAssigned(transition.assignments()));
        return Stream.concat(asked, done);
    }

    private static Stream<Expression> of(List<Automaton.Send> sends) {
        return sends.stream().flatMap(send -> send.emission().values().stream());
    }

    private static Stream<Expression> ofAssigned(List<Automaton.Assignment> assignments) {
        return assignments.stream().map(Automaton.Assignment::value);
    }

    /** The operands of a row of {@code &&} or {@code ||}, all at once: it may be long. */
    public static List<Expression> row(Expression row, BinaryOperator operator) {
        List<Expression> operands = new ArrayList<>();
        Deque<Expression> open = new ArrayDeque<>(List.of(row));
        while (!open.isEmpty()) {
            Expression next = open.pop();
            if (next instanceof Expression.Binary binary && binary.operator() == operator) {
                open.push(binary.right());
                open.push(binary.left());
            } else {
                operands.add(next);
            }
        }
        return operands;
    }
}
