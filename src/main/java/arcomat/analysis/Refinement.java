package arcomat.analysis;

import arcomat.analysis.Verdict.Answer;
import arcomat.analysis.Verdict.Explored;
import arcomat.analysis.Verdict.Sentence;
import arcomat.analysis.engine.AtomicSide;
import arcomat.analysis.engine.Comparison;
import arcomat.analysis.engine.CompositeSide;
import arcomat.analysis.engine.Inclusion;
import arcomat.analysis.engine.Outputs;
import arcomat.analysis.engine.Side;
import arcomat.analysis.engine.TooManyMessages;
import arcomat.model.Component;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Whether one component keeps what another one promises: every trace of the first, restricted to
 * the ports of the second, is a trace of the second (Ringert, Rumpe, Wortmann 2013, section 3). The
 * first may have further ports.
 */
public final class Refinement {
    private Refinement() {}

    /** A conjunction on the right is kept if each of its automata is. */
    public static Verdict check(Promise left, Promise right, Budget budget) {
        Optional<Verdict> interfaces = Interfaces.compare(left, right);
        if (interfaces.isPresent()) {
            return interfaces.get();
        }
        if (left.component().profile() == Component.Profile.EVENT_DRIVEN
                && (left.isComposition() || right.isComposition())) {
            return Verdict.unknown(
                    "compositions of components that handle events are not compared");
        }
        Optional<Verdict> byParts = PartByPart.check(left, right, budget);
        if (byParts.isPresent()) {
            return byParts.get();
        }
        List<Verdict> verdicts = new ArrayList<>();
        for (Promise each : right.each()) {
            verdicts.add(compare(left, each, budget));
        }
        return all(verdicts);
    }

    /** Fails as briefly as possible; holds only if all do. */
    private static Verdict all(List<Verdict> verdicts) {
        if (verdicts.size() == 1) {
            return verdicts.get(0);
        }
        Verdict worst = null;
        for (Verdict verdict : verdicts) {
            boolean shorter =
                    worst != null
                            && verdict.answer() == Answer.FAILS
                            && worst.answer() == Answer.FAILS
                            && verdict.trace().size() < worst.trace().size();
            if (worst == null || rank(verdict) > rank(worst) || shorter) {
                worst = verdict;
            }
        }
        return worst == null ? Vacuity.nothingAsked() : worst;
    }

    private static int rank(Verdict verdict) {
        return switch (verdict.answer()) {
            case HOLDS -> 0;
            case UNKNOWN -> 1;
            case FAILS -> 2;
        };
    }

    private static Verdict compare(Promise left, Promise right, Budget budget) {
        Outputs outputs = new Outputs();
        List<Port> observed = right.component().outputs();
        List<String> names = observed.stream().map(Port::name).toList();
        Side mine = null;
        Side theirs = null;
        try {
            mine = side(left, names, outputs);
            theirs = side(right, names, outputs);
            Comparison comparison = new Comparison(mine, theirs, observed, outputs, budget);
            Inclusion.Result result = comparison.run();
            Explored explored = new Explored(result.pairs(), mine.size(), theirs.size());
            if (result.stopped().isPresent()) {
                return Verdict.unknown(result.stopped().get(), explored);
            }
            return result.failure().isPresent()
                    ? failure(left, right, comparison, result, explored)
                    : holds(right, theirs, result, explored);
        } catch (TooManyMessages problem) {
            return Verdict.unknown(
                    problem.getMessage(),
                    new Explored(
                            0, mine == null ? 0 : mine.size(), theirs == null ? 0 : theirs.size()));
        }
    }

    private static Side side(Promise promise, List<String> observed, Outputs outputs) {
        return promise.isComposition()
                ? new CompositeSide(promise.component(), promise.arguments(), observed, outputs)
                : new AtomicSide(promise.behaviour(), observed, outputs);
    }

    private static Verdict failure(
            Promise left,
            Promise right,
            Comparison comparison,
            Inclusion.Result result,
            Explored explored) {
        Inclusion.Failure failure = result.failure().orElseThrow();
        List<Moment> trace = comparison.moments(failure);
        List<Sentence> explanation =
                Explanation.of(left, right, comparison.forbidden(failure), trace.size() - 1);
        return new Verdict(
                Answer.FAILS,
                "behaviour",
                result.simulation(),
                trace,
                explanation,
                List.of(),
                explored);
    }

    private static Verdict holds(
            Promise right, Side theirs, Inclusion.Result result, Explored explored) {
        return Verdict.holds(result.simulation(), Vacuity.notes(right, theirs, result), explored);
    }
}
