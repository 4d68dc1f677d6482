package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.reachability.Subject;
import arcomat.semantics.expression.Fault;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** Run errors of one kind, one finding for each transition that can go wrong. */
abstract class FaultAnalysis extends WitnessedAnalysis<Integer> {
    private final String code;
    private final Fault.Kind kind;

    FaultAnalysis(String code, Fault.Kind kind, Subject subject) {
        super(subject);
        this.code = code;
        this.kind = kind;
    }

    @Override
    final void see(Situation situation) {
        faults(situation)
                .filter(fault -> fault.kind() == kind)
                .forEach(fault -> witness(fault.taken().orElseThrow().index(), situation));
    }

    /** Of the guards, and of what is done where they are true. */
    private static Stream<Fault> faults(Situation situation) {
        return Stream.concat(
                situation.faults().stream(),
                situation.alternatives().stream().flatMap(each -> each.fault().stream()));
    }

    @Override
    final Finding finding(Integer transition, Situation situation) {
        String problem =
                faults(situation)
                        .filter(fault -> fault.taken().orElseThrow().index() == transition)
                        .map(Fault::problem)
                        .findFirst()
                        .orElseThrow();
        String message = "run error in %s: %s".formatted(words(situation), problem);
        return finding(
                Diagnostic.error(code, subject.transition(transition).span(), message), situation);
    }
}
