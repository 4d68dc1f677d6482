package arcomat.analysis.automaton;

import arcomat.analysis.smt.Subject;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * An integer without a range that wraps around, as Java's do. All that is found beside it is right
 * with that; but seldom is it what the author had in mind.
 */
final class IntegerOverflow implements Analysis {
    static final String CODE = "ARC1009";

    private final Subject subject;
    private final Story story;
    private final Witnesses<Integer> overflows = new Witnesses<>();

    IntegerOverflow(Subject subject) {
        this.subject = subject;
        this.story = new Story(subject);
    }

    @Override
    public void see(Situation situation) {
        situation.wrapping().forEach(transition -> overflows.add(transition, situation));
    }

    @Override
    public List<Finding> findings(Knowledge knowledge) {
        List<Finding> findings = new ArrayList<>();
        for (Map.Entry<Integer, Situation> entry : overflows.all().entrySet()) {
            Situation situation = entry.getValue();
            String message =
                    "in %s on %s an integer overflows and wraps around; give ports and variables ranges"
                            .formatted(
                                    story.words(situation.visit().configuration()),
                                    story.words(situation.letter()));
            Diagnostic diagnostic =
                    Diagnostic.warning(CODE, subject.transition(entry.getKey()).span(), message);
            findings.add(story.finding(diagnostic, situation));
        }
        return findings;
    }
}
