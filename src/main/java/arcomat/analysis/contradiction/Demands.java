package arcomat.analysis.contradiction;

import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.game.CounterStrategy.Turn;
import arcomat.analysis.refinement.Explanation;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.product.Counterexample.Allowed;

import java.util.ArrayList;
import java.util.List;

/** Says what requirements ask for where they contradict each other. */
final class Demands {
    private Demands() {}

    static Contradiction.Step step(Turn turn, List<Promise> requirements) {
        List<Sentence> sentences = new ArrayList<>();
        boolean errors = turn.demands().stream().anyMatch(each -> errs(each.allowed()));
        for (Turn.Demand demand : turn.demands()) {
            Promise requirement = requirements.get(demand.requirement());
            boolean errs = errs(demand.allowed());
            boolean only = demand.allowed().stream().allMatch(Allowed::error);
            for (Allowed allowed : demand.allowed()) {
                String words =
                        allowed.error()
                                ? only ? "only an error" : "an error"
                                : Explanation.words(allowed, errors && !errs);
                sentences.add(Explanation.allows(requirement, allowed, words));
            }
        }
        return new Contradiction.Step(turn.input(), turn.answers(), sentences);
    }

    private static boolean errs(List<Allowed> allowed) {
        return allowed.stream().anyMatch(Allowed::error);
    }
}
