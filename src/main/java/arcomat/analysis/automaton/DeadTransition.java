package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.smt.RunProperty;
import arcomat.analysis.smt.Subject;
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
        List<Integer> ways = subject.ways(transition);
        return ways.get(0) != transition && ways.stream().allMatch(each -> isDead(each, knowledge));
    }

    /** Of some ways through the statements of a transition it says where they lead. */
    private String name(int transition, Knowledge knowledge) {
        String move = "transition " + subject.move(transition);
        return subject.ways(transition).stream().allMatch(each -> isDead(each, knowledge))
                ? move
                : "the way through %s where %s"
                        .formatted(
                                move,
                                subject.transition(transition)
                                        .guard()
                                        .map(ExpressionText::of)
                                        .orElse("nothing is asked"));
    }

    private Diagnostic diagnostic(int transition, Knowledge knowledge) {
        int source = subject.transition(transition).source();
        String reason =
                knowledge.happens(new RunProperty.Reached(source))
                        ? "no input enables it in any configuration that is reached"
                        : "its source %s is never reached".formatted(subject.state(source));
        return Diagnostic.warning(
                CODE,
                subject.transition(transition).span(),
                "%s can never be taken: %s".formatted(name(transition, knowledge), reason));
    }
}
