package arcomat.analysis.search.system;

import arcomat.model.Value;
import arcomat.semantics.expression.DataSorts;

/** Where a side has data, as places of {@link DataSorts}. */
interface DataPlaces {
    int NOWHERE = -1;

    /** The place of an input port, by its name; {@link #NOWHERE} if the side has none. */
    int input(String port);

    /** The place of a compared output port, by its position; {@link #NOWHERE} if there is none. */
    int output(int observed);

    /** Tells all values that a configuration may still use. */
    void held(int configuration, Holding holding);

    /** Told of a value at a place. */
    interface Holding {
        void value(int place, Value value);
    }
}
