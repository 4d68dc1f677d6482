package arcomat.analysis.smt;

import arcomat.model.Value;
import arcomat.semantics.value.GivenUp;

import java.util.List;
import java.util.Optional;

/** Asked for messages that show something of some facts that was not met before. */
interface FactSolver {
    /** Messages that show just this are of no interest any more. */
    void exclude(List<Optional<Value>> shown);

    /**
     * Other messages, one by port; empty where it is proved that there are none.
     *
     * @throws GivenUp where it does not know
     */
    Optional<Value[]> another();

    /**
     * What was taken for possible is not so: some operation has another result.
     *
     * @throws GivenUp where there is nothing to learn from it
     */
    void learn(Value[] example);
}
