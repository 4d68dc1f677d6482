package arcomat.analysis.automaton;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.semantics.Promise;

import java.util.List;

/**
 * What the analyses found about one automaton.
 *
 * @param promise the automaton alone, with the arguments of its component
 * @param findings by place in the text
 * @param obstacle why not everything is known; else empty. Findings hold in any case
 * @param explored how many configurations were looked at
 */
public record Examination(Promise promise, List<Finding> findings, String obstacle, int explored) {
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

    public Component component() {
        return promise.component();
    }

    public Automaton automaton() {
        return promise.automata().get(0);
    }

    /** The same with some of the findings. */
    public Examination with(List<Finding> some) {
        return new Examination(promise, some, obstacle, explored);
    }

    /**
     * A component whose automata cannot be examined as they stand.
     *
     * @param reason what is missing, and what to do
     */
    public record Unexamined(String component, String reason) {}
}
