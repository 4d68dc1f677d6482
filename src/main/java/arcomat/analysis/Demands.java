package arcomat.analysis;

import arcomat.analysis.Verdict.Sentence;
import arcomat.analysis.engine.Comparison.Allowed;
import arcomat.analysis.game.Turn;

import java.util.ArrayList;
import java.util.List;

/** Says what requirements ask for where they contradict each other. */
final class Demands {
    private Demands() {}

    static Contradiction.Step step(Turn turn, List<Promise> requirements) {
        List<Sentence> sentences = new ArrayList<>();
        for (Turn.Demand demand : turn.demands()) {
            Promise requirement = requirements.get(demand.requirement());
            for (Allowed allowed : demand.allowed()) {
                sentences.add(
                        new Sentence(
                                "%s allows %s%s"
                                        .formatted(
                                                requirement.title(),
                                                Explanation.words(allowed.sent()),
                                                Explanation.by(
                                                        requirement,
                                                        allowed.configuration(),
                                                        allowed.causes())),
                                Explanation.place(requirement, allowed.causes())));
            }
        }
        return new Contradiction.Step(turn.input(), turn.answers(), sentences);
    }
}
