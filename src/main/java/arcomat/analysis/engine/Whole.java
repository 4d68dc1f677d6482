package arcomat.analysis.engine;

import arcomat.semantics.Configuration;
import arcomat.semantics.Sent;

import java.util.List;

/**
 * Where a composition is.
 *
 * @param parts one configuration per automaton of each part
 * @param registers what is visible in the next slice, one per signal with delay
 */
record Whole(List<List<Configuration>> parts, List<Sent> registers) {
    Whole {
        parts = List.copyOf(parts);
        registers = List.copyOf(registers);
    }
}
