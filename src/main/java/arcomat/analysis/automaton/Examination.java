package arcomat.analysis.automaton;

import arcomat.analysis.Verdict.Answer;
import arcomat.model.Automaton;
import arcomat.model.Component;

import java.util.List;

/**
 * What the analyses found about one automaton.
 *
 * @param findings by place in the text
 * @param obstacle why not everything was looked at; else empty. Findings hold in any case
 * @param explored how many configurations were looked at
 */
public record Examination(
        Component component,
        Automaton automaton,
        List<Finding> findings,
        String obstacle,
        int explored) {
    public Examination {
        findings = List.copyOf(findings);
    }

    /** Whether there is nothing to find, something was found, or not everything was looked at. */
    public Answer answer() {
        if (!findings.isEmpty()) {
            return Answer.FAILS;
        }
        return obstacle.isEmpty() ? Answer.HOLDS : Answer.UNKNOWN;
    }
}
