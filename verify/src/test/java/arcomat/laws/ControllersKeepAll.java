package arcomat.laws;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.contradiction.Contradictions;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Conjunctions;
import arcomat.laws.draw.Draw;
import arcomat.laws.naive.NaiveGame;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A controller refines what it was made for; a contradiction beats all, and with fewer none is
 * left.
 */
final class ControllersKeepAll implements Law {
    private static final String SEVERAL = "r.Main";
    private static final int MOST_INPUTS = 4;

    @Override
    public String name() {
        return "4 controllers keep all";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        Conjunctions conjunctions = new Conjunctions(draw);
        return List.of(ComponentText.types(), conjunctions.one(), conjunctions.several("r"));
    }

    @Override
    public Outcome check(Models models) {
        Component several = models.component(SEVERAL);
        Promise promise = Questions.promise(several);
        Consistency found = Contradictions.check(promise, true, Questions.budget());
        if (found.answer() == Answer.UNKNOWN) {
            return Outcome.SKIPPED;
        }
        return (found.answer() == Answer.HOLDS
                        ? kept(promise, found)
                        : contradictory(promise, found))
                .orElse(Outcome.KEPT);
    }

    private static Optional<Outcome> kept(Promise promise, Consistency found) {
        if (found.controller().isPresent()) {
            Promise controller = Questions.promise(found.controller().get());
            Verdict verdict = Questions.refines(controller, promise);
            if (Questions.fails(verdict)) {
                return broken("a controller does not refine: " + Questions.text(verdict));
            }
        }
        if (!NaiveGame.isPlayed(promise.component())) {
            return Optional.empty();
        }
        boolean lost = new NaiveGame(promise.component(), promise.automata()).isLost(MOST_INPUTS);
        return lost
                ? broken("there is no contradiction, but every system loses")
                : Optional.empty();
    }

    private static Optional<Outcome> contradictory(Promise promise, Consistency found) {
        Component component = promise.component();
        for (Contradiction each : found.contradictions()) {
            boolean played = NaiveGame.isPlayed(component);
            if (played && each.word().isPresent()) {
                NaiveGame game = new NaiveGame(component, each.requirements());
                if (game.isAnswered(each.word().get())) {
                    return broken("a contradicting word can be answered");
                }
                boolean shorter =
                        !each.word().get().isEmpty()
                                && !game.isAnswered(
                                        each.word().get().subList(0, each.word().get().size() - 1));
                if (shorter) {
                    return broken("a contradicting word is too long");
                }
            }
            Optional<Outcome> fewer = each.minimal() ? fewer(promise, each) : Optional.empty();
            if (fewer.isPresent()) {
                return fewer;
            }
        }
        return Optional.empty();
    }

    /** Without one of a minimal subset the others can be kept. */
    private static Optional<Outcome> fewer(Promise promise, Contradiction contradiction) {
        for (Automaton left : contradiction.requirements()) {
            List<Automaton> others = new ArrayList<>(contradiction.requirements());
            others.remove(left);
            Promise rest = new Promise(promise.component(), List.of(), others);
            boolean contradictory =
                    !others.isEmpty()
                            && Contradictions.check(rest, false, Questions.budget()).answer()
                                    == Answer.FAILS;
            if (contradictory) {
                return broken("a minimal contradiction is not minimal");
            }
        }
        return Optional.empty();
    }

    private static Optional<Outcome> broken(String problem) {
        return Optional.of(Outcome.broken(problem, "contradictions --all " + SEVERAL));
    }
}
