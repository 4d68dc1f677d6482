package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.ExpressionText;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;

/** A transition that no run takes: nothing enables it, or its source is never reached. */
final class DeadTransition extends Analysis {
    static final String CODE = "ARC1004";

    DeadTransition(Subject subject) {
        super(subject);
    }

    @Override
    List<Finding> findings(Knowledge knowledge) {
        List<Finding> findings = new ArrayList<>();
        for (int i = 0; i < subject.automaton().transitions().size(); i++) {
            if (isDead(i, knowledge) && !isToldBefore(i, knowledge)) {
                findings.add(Finding.never(diagnostic(i, knowledge)));
            }
        }
        return findings;
    }

    private static boolean isDead(int transition, Knowledge knowledge) {
        return knowledge.neverHappens(new RunProperty.Enabled(transition));
    }

    /** A transition with choices, of which no way can be taken, is told once. */
    private boolean isToldBefore(int transition, Knowledge knowledge) {
        return subject.ways(transition).get(0) != transition && isWhole(transition, knowledge);
    }

    private boolean isWhole(int transition, Knowledge knowledge) {
        return subject.ways(transition).stream().allMatch(each -> isDead(each, knowledge));
    }

    private Diagnostic diagnostic(int transition, Knowledge knowledge) {
        Automaton.Transition dead = subject.transition(transition);
        String reason =
                knowledge.happens(new RunProperty.Reached(dead.source()))
                        ? "no input enables it in any configuration that is reached"
                        : "its source %s is never reached".formatted(subject.state(dead.source()));
        String move = "transition " + subject.move(transition);
        if (dead.guard().isEmpty() || isWhole(transition, knowledge)) {
            return Diagnostic.warning(
                    CODE, dead.span(), "%s can never be taken: %s".formatted(move, reason));
        }
        // Others of its ways are taken: the place is where this one turns off.
        Expression guard = dead.guard().get();
        return Diagnostic.warning(
                CODE,
                lastOf(guard).span(),
                "the way through %s where %s can never be taken: %s"
                        .formatted(move, ExpressionText.of(guard), reason));
    }

    private static Expression lastOf(Expression guard) {
        return guard instanceof Expression.Binary both && both.operator() == BinaryOperator.AND
                ? both.right()
                : guard;
    }
}
