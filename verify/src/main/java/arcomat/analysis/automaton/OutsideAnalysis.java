package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.reachability.Subject;

import java.util.ArrayList;
import java.util.List;

/**
 * Keeps all that happens for whoever is asked at the end: what comes from outside is asked once,
 * and not at each letter, since it is asked in a thread of its own.
 */
final class OutsideAnalysis extends Analysis {
    private final OutsideQuestion question;
    private final List<Situation> seen = new ArrayList<>();

    OutsideAnalysis(OutsideQuestion question, Subject subject) {
        super(subject);
        this.question = question;
    }

    @Override
    void see(Situation situation) {
        if (situation.visit().number() >= 0) {
            seen.add(situation); // what a solver finds is some of what is there, and not all
        }
    }

    @Override
    List<Finding> findings(Knowledge knowledge) {
        return question.ask(subject, knowledge.explored(), seen).stream()
                .map(
                        answer ->
                                answer.where()
                                        .map(visit -> finding(answer.diagnostic(), visit))
                                        .orElseGet(() -> Finding.never(answer.diagnostic())))
                .toList();
    }
}
