package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.model.Invariant;
import arcomat.semantics.Promise;

/** Who decides what models say they keep. */
interface PromiseProver {
    /** The engine of this tool. */
    PromiseProver ENGINE =
            new PromiseProver() {
                @Override
                public Verdict refines(Promise left, Promise right, Budget budget) {
                    return Refinement.check(left, right, budget);
                }

                @Override
                public Verdict keeps(Promise side, Invariant invariant, Budget budget) {
                    return InvariantProof.check(
                            side.component(), side.arguments(), invariant, budget);
                }
            };

    Verdict refines(Promise left, Promise right, Budget budget);

    /**
     * @param side the component with its arguments
     */
    Verdict keeps(Promise side, Invariant invariant, Budget budget);

    /** What a proof of it is called. */
    static String title(Promise left, Promise right) {
        return left.title() + " refines " + right.title();
    }

    /** As above. */
    static String title(Promise side, Invariant invariant) {
        return side.title() + " keeps invariant " + invariant.name();
    }
}
