package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.reachability.Subject;
import arcomat.source.Diagnostic;

/**
 * An integer without a range that wraps around, as Java's do. All that is found beside it is right
 * with that; but seldom is it what the author had in mind.
 */
final class IntegerOverflow extends WitnessedAnalysis<Integer> {
    static final String CODE = "ARC1009";

    IntegerOverflow(Subject subject) {
        super(subject);
    }

    @Override
    void see(Situation situation) {
        situation.wrapping().forEach(transition -> witness(transition, situation));
    }

    @Override
    Finding finding(Integer transition, Situation situation) {
        String message =
                "in %s an integer overflows and wraps around; give ports and variables ranges"
                        .formatted(words(situation));
        return finding(
                Diagnostic.warning(CODE, subject.transition(transition).span(), message),
                situation);
    }
}
