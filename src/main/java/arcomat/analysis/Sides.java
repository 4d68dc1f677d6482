package arcomat.analysis;

import arcomat.analysis.Verdict.Explored;
import arcomat.analysis.engine.AtomicSide;
import arcomat.analysis.engine.Comparison;
import arcomat.analysis.engine.CompositeSide;
import arcomat.analysis.engine.HeldInputs;
import arcomat.analysis.engine.Outputs;
import arcomat.analysis.engine.Side;
import arcomat.model.Port;

import java.util.List;

/** Both sides of a comparison, ready to be explored. */
record Sides(Side left, Side right, List<Port> observed, Outputs outputs) {

    static Sides of(Promise left, Promise right, Budget budget) {
        Outputs outputs = new Outputs();
        List<Port> observed = right.ports().stream().filter(port -> !port.isInput()).toList();
        List<String> names = observed.stream().map(Port::name).toList();
        return new Sides(
                HeldInputs.of(side(left, names, outputs, budget)),
                side(right, names, outputs, budget),
                observed,
                outputs);
    }

    private static Side side(
            Promise promise, List<String> observed, Outputs outputs, Budget budget) {
        return promise.isComposition()
                ? new CompositeSide(
                        promise.component(), promise.arguments(), observed, outputs, budget)
                : new AtomicSide(promise.behaviour(), observed, outputs, budget);
    }

    Comparison comparison(Budget budget) {
        return new Comparison(left, right, observed, outputs, budget);
    }

    Explored explored(long pairs) {
        return new Explored(pairs, left.size(), right.size());
    }
}
