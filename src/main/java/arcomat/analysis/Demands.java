package arcomat.analysis;

import arcomat.analysis.Verdict.Sentence;
import arcomat.analysis.engine.Comparison.Allowed;
import arcomat.analysis.game.Turn;
import arcomat.semantics.Sent;

import java.util.ArrayList;
import java.util.Collection;
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
                                requirement.title()
                                        + " "
                                        + words(allowed)
                                        + Explanation.by(
                                                requirement,
                                                allowed.configuration(),
                                                allowed.causes()),
                                Explanation.place(requirement, allowed.causes())));
            }
        }
        return new Contradiction.Step(turn.input(), turn.answers(), sentences);
    }

    private static String words(Allowed allowed) {
        if (allowed.error()) {
            return "ends in an error";
        }
        Collection<Sent> sent = allowed.sent().values();
        boolean silent =
                sent.contains(Sent.SILENCE)
                        && sent.stream()
                                .allMatch(
                                        s -> s.equals(Sent.SILENCE) || s instanceof Sent.Anything);
        return "allows " + (silent ? "only silence" : Explanation.words(allowed.sent()));
    }
}
