package arcomat.analysis.automaton;

import arcomat.analysis.smt.Subject;
import arcomat.semantics.expression.Fault;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Run errors of one kind, one finding for each transition that can go wrong. */
abstract class FaultAnalysis implements Analysis {
    private final String code;
    private final Fault.Kind kind;
    private final Subject subject;
    private final Story story;
    private final Witnesses<Integer> faults = new Witnesses<>();

    FaultAnalysis(String code, Fault.Kind kind, Subject subject) {
        this.code = code;
        this.kind = kind;
        this.subject = subject;
        this.story = new Story(subject);
    }

    @Override
    public final void see(Situation situation) {
        situation.faults().forEach(fault -> note(fault, situation));
        for (Situation.Alternative each : situation.alternatives()) {
            each.fault().ifPresent(fault -> note(fault, situation));
        }
    }

    private void note(Fault fault, Situation situation) {
        if (fault.kind() == kind) {
            faults.add(fault.taken().orElseThrow().index(), situation);
        }
    }

    @Override
    public final List<Finding> findings(Knowledge knowledge) {
        List<Finding> findings = new ArrayList<>();
        for (Map.Entry<Integer, Situation> entry : faults.all().entrySet()) {
            findings.add(finding(entry.getKey(), entry.getValue()));
        }
        return findings;
    }

    private Finding finding(int transition, Situation situation) {
        String message =
                "run error in %s on %s: %s"
                        .formatted(
                                story.words(situation.visit().configuration()),
                                story.words(situation.letter()),
                                problem(transition, situation));
        Diagnostic diagnostic =
                Diagnostic.error(code, subject.transition(transition).span(), message);
        return story.finding(diagnostic, situation);
    }

    /** Of the guard, or of what is done where it is true. */
    private static String problem(int transition, Situation situation) {
        return Stream.concat(
                        situation.faults().stream(),
                        situation.alternatives().stream().flatMap(each -> each.fault().stream()))
                .filter(fault -> fault.taken().orElseThrow().index() == transition)
                .map(Fault::problem)
                .findFirst()
                .orElseThrow();
    }
}
