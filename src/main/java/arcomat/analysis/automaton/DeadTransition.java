package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.smt.RunProperty;
import arcomat.analysis.smt.Subject;
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
            if (knowledge.neverHappens(new RunProperty.Enabled(i))) {
                findings.add(Finding.never(diagnostic(i, knowledge)));
            }
        }
        return findings;
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
                "transition %s can never be taken: %s".formatted(subject.move(transition), reason));
    }
}
