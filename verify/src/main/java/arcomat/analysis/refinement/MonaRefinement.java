package arcomat.analysis.refinement;

import arcomat.analysis.mona.InclusionProblem;
import arcomat.analysis.mona.InclusionProblem.NotForMona;
import arcomat.analysis.mona.MonaFormula;
import arcomat.analysis.mona.Replay;
import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.semantics.Promise;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Refinement as a question to the program MONA, a second opinion beside {@link Refinement}: the
 * formula that it is to decide, and its answer as a verdict.
 *
 * @param settled the answer where the program need not or cannot be asked
 * @param question present where it can
 */
public record MonaRefinement(
        Promise left,
        Promise right,
        Optional<Verdict> settled,
        Optional<InclusionProblem> question) {

    /**
     * Spells the question out.
     *
     * @param budget for the states of both sides
     */
    public static MonaRefinement of(Promise left, Promise right, Budget budget) {
        Optional<Verdict> interfaces = Interfaces.compare(left, right);
        if (interfaces.isPresent()) {
            return settled(left, right, interfaces.get());
        }
        return Budget.within(
                () -> asked(left, right, budget),
                reason -> settled(left, right, Verdict.unknown(reason, Explored.NOTHING)));
    }

    private static MonaRefinement settled(Promise left, Promise right, Verdict verdict) {
        return new MonaRefinement(left, right, Optional.of(verdict), Optional.empty());
    }

    private static MonaRefinement asked(Promise left, Promise right, Budget budget) {
        try {
            refuse(left);
            refuse(right);
            InclusionProblem question =
                    InclusionProblem.of(
                            new InclusionProblem.Named(left.title(), left.behaviour()),
                            right.title(),
                            right.each().stream()
                                    .map(
                                            each ->
                                                    new InclusionProblem.Named(
                                                            each.title(), each.behaviour()))
                                    .toList(),
                            budget);
            return new MonaRefinement(left, right, Optional.empty(), Optional.of(question));
        } catch (NotForMona problem) {
            return settled(
                    left,
                    right,
                    Verdict.unknown(String.valueOf(problem.getMessage()), Explored.NOTHING));
        }
    }

    private static void refuse(Promise promise) {
        if (promise.isComposition()) {
            throw new NotForMona(
                    promise.title() + " is composed of parts; MONA is asked about automata only");
        }
        if (promise.component().profile() == arcomat.model.Component.Profile.EVENT_DRIVEN) {
            throw new NotForMona(
                    promise.title() + " handles events; MONA is asked about slices only");
        }
    }

    /** What the text of the formula is made from. */
    public MonaFormula formula() {
        return question.orElseThrow().formula();
    }

    /** The verdict where the formula is valid. */
    public Verdict holds() {
        return Verdict.holds(
                Optional.empty(),
                List.of("decided by MONA, which does not say whether the promise is empty"),
                explored());
    }

    /**
     * The verdict where it is not.
     *
     * @param rows the counterexample: per bit one character for each position, 0, 1, or X where it
     *     does not matter
     */
    public Verdict fails(Map<String, String> rows) {
        Optional<Replay.Shown> shown = new Replay(question.orElseThrow(), rows).run();
        if (shown.isEmpty()) {
            return unknown("MONA's counterexample is no run of the models: please report this");
        }
        Promise forbidding = right.each().get(shown.get().right());
        List<Moment> trace = shown.get().moments();
        return Verdict.fails(
                trace,
                Explanation.of(left, forbidding, shown.get().forbidden(), trace.size() - 1),
                explored());
    }

    /** The verdict where the program has not answered. */
    public Verdict unknown(String reason) {
        return Verdict.unknown(reason, explored());
    }

    private Explored explored() {
        InclusionProblem asked = question.orElseThrow();
        return new Explored(0, asked.leftStates(), asked.rightStates());
    }
}
