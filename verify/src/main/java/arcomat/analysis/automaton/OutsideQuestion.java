package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.automaton.exploration.Visit;
import arcomat.analysis.reachability.Subject;
import arcomat.source.Diagnostic;

import java.util.List;
import java.util.Optional;

/** A question about an automaton that somebody else brings. */
public interface OutsideQuestion {
    /**
     * What is found.
     *
     * @param seen all that was looked at, in this order
     */
    List<Answer> ask(Subject subject, Exploration explored, List<Situation> seen);

    /**
     * @param where it is seen, for a run to there; empty where no run shows it
     */
    record Answer(Diagnostic diagnostic, Optional<Visit> where) {}
}
