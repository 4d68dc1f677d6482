package arcomat.analysis.search.system;

import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.semantics.expression.Sent;

import java.util.function.IntFunction;

/** A system that is made of a network, and has numbers for it besides. */
public interface PackableSystem extends TransitionSystem {
    /** Whether its configurations can be packed, as far as that can be told beforehand. */
    boolean canBePacked();

    /**
     * Its network in numbers, from which this system's configurations can be told.
     *
     * @throws PackedNetwork.CannotPack where there is none
     */
    PackedNetwork packed();

    /** The configuration with a number. */
    GlobalState state(int configuration);

    /** The number of a configuration. */
    int configuration(GlobalState state);

    /**
     * The number of what compared ports show.
     *
     * @param shown what is sent on the signal of one of them
     */
    int cube(IntFunction<Sent> shown);
}
