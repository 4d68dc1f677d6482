package arcomat.analysis;

import arcomat.analysis.Verdict.Explored;
import arcomat.analysis.engine.AtomicSide;
import arcomat.analysis.engine.CompositeSide;
import arcomat.analysis.engine.Outputs;
import arcomat.analysis.engine.Side;
import arcomat.model.Port;

import java.util.List;

/** Both sides of a comparison, ready to be explored. */
record Sides(Side left, Side right, List<Port> observed, Outputs outputs) {

    static Sides of(Promise left, Promise right) {
        Outputs outputs = new Outputs();
        List<Port> observed = right.ports().stream().filter(port -> !port.isInput()).toList();
        List<String> names = observed.stream().map(Port::name).toList();
        return new Sides(
                side(left, names, outputs), side(right, names, outputs), observed, outputs);
    }

    private static Side side(Promise promise, List<String> observed, Outputs outputs) {
        return promise.isComposition()
                ? new CompositeSide(promise.component(), promise.arguments(), observed, outputs)
                : new AtomicSide(promise.behaviour(), observed, outputs);
    }

    Explored explored(long pairs) {
        return new Explored(pairs, left.size(), right.size());
    }
}
