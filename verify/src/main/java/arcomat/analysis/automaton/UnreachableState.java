package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton.Transition;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;

/** A state that no run reaches. */
final class UnreachableState extends Analysis {
    static final String CODE = "ARC1003";

    UnreachableState(Subject subject) {
        super(subject);
    }

    @Override
    List<Finding> findings(Knowledge knowledge) {
        List<Finding> findings = new ArrayList<>();
        for (int state = 0; state < subject.automaton().states().size(); state++) {
            if (knowledge.neverHappens(new RunProperty.Reached(state))) {
                findings.add(Finding.never(diagnostic(state)));
            }
        }
        return findings;
    }

    private Diagnostic diagnostic(int state) {
        // Statements may lead there in several ways.
        List<Span> leading =
                subject.automaton().transitions().stream()
                        .filter(t -> t.target() == state && t.source() != state)
                        .map(Transition::span)
                        .distinct()
                        .toList();
        String reason =
                leading.isEmpty()
                        ? "no transition leads to it"
                        : "no run carries out a transition that leads to it";
        Diagnostic diagnostic =
                Diagnostic.warning(
                        CODE,
                        subject.automaton().places().get(state),
                        "state %s is never reached: %s".formatted(subject.state(state), reason));
        for (Span transition : leading) {
            diagnostic = diagnostic.withRelated(transition, "leads to it");
        }
        return diagnostic;
    }
}
