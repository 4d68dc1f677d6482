package arcomat.analysis.automaton;

import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/** A transition that no run takes: nothing enables it, or its source is never reached. */
final class DeadTransition implements Analysis {
    static final String CODE = "ARC1004";

    private final Subject subject;
    private final BitSet enabled = new BitSet();

    DeadTransition(Subject subject) {
        this.subject = subject;
    }

    @Override
    public void see(Situation situation) {
        situation.alternatives().forEach(each -> enabled.set(each.taken().index()));
    }

    @Override
    public List<Finding> findings(Exploration explored) {
        List<Finding> findings = new ArrayList<>();
        for (int i = 0; i < subject.automaton().transitions().size(); i++) {
            if (explored.isComplete() && !enabled.get(i)) {
                findings.add(Finding.never(diagnostic(i, explored)));
            }
        }
        return findings;
    }

    private Diagnostic diagnostic(int transition, Exploration explored) {
        int source = subject.transition(transition).source();
        String reason =
                explored.hasReached(source)
                        ? "no input enables it in any configuration that is reached"
                        : "its source %s is never reached".formatted(subject.state(source));
        return Diagnostic.warning(
                CODE,
                subject.transition(transition).span(),
                "transition %s can never be taken: %s".formatted(subject.move(transition), reason));
    }
}
