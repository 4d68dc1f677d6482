package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.product.Comparison;
import arcomat.analysis.search.side.AtomicSide;
import arcomat.analysis.search.side.CompositeSide;
import arcomat.analysis.search.side.HeldInputs;
import arcomat.analysis.search.side.LateSide;
import arcomat.analysis.search.side.ShownSide;
import arcomat.analysis.search.side.Side;
import arcomat.analysis.search.step.Outputs;
import arcomat.model.Port;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Both sides of a comparison, ready to be explored. Where only one of them sends with delay, they
 * are compared by what is seen.
 */
public final class Sides {
    private final Side plainLeft;
    private final Side plainRight;
    private final Side left;
    private final Side right;
    private final List<Port> observed;
    private final Outputs outputs;

    private Sides(Side plainLeft, Side plainRight, List<Port> observed, Outputs outputs) {
        this.plainLeft = plainLeft;
        this.plainRight = plainRight;
        this.observed = observed;
        this.outputs = outputs;
        List<Boolean> total = observed.stream().map(Port::total).toList();
        this.left = ShownSide.beside(plainLeft, plainRight, total, outputs);
        this.right = ShownSide.beside(plainRight, plainLeft, total, outputs);
    }

    public static Sides of(Promise left, Promise right, Budget budget) {
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

    /** The same with a right side that is so many slices late. */
    Sides late(int slices, Budget budget) {
        Side late = new LateSide(plainRight, slices, observed.size(), outputs, budget);
        return new Sides(plainLeft, late, observed, outputs);
    }

    Side left() {
        return left;
    }

    Side right() {
        return right;
    }

    List<Port> observed() {
        return observed;
    }

    Outputs outputs() {
        return outputs;
    }

    /** Compared ports on which only one of the sides sends with delay, by name. */
    List<String> shifted() {
        return Stream.of(left, right).flatMap(this::late).sorted().map(this::name).toList();
    }

    /** Compared ports on which one of the sides is seen later than it sends, by name. */
    static Set<String> late(Promise left, Promise right, boolean isLeft) {
        Sides sides = of(left, right, Budget.ofMemory());
        return sides.late(isLeft ? sides.left : sides.right)
                .map(sides::name)
                .collect(Collectors.toSet());
    }

    private Stream<Integer> late(Side side) {
        return side instanceof ShownSide shown ? shown.late().stream().boxed() : Stream.of();
    }

    private String name(int port) {
        return observed.get(port).name();
    }

    public Comparison comparison(Budget budget) {
        return new Comparison(left, right, observed, outputs, budget);
    }

    Explored explored(long pairs) {
        return new Explored(pairs, left.size(), right.size());
    }
}
