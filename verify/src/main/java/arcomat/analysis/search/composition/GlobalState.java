package arcomat.analysis.search.composition;

import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;

import java.util.List;

/**
 * Where a composition is.
 *
 * @param parts one configuration per automaton of each part
 * @param registers what has been sent and can still be read: in slices one per signal with delay,
 *     with events one per latched port
 * @param problem what ended the run in an error; else empty
 */
public record GlobalState(List<List<Configuration>> parts, List<Sent> registers, String problem) {
    public GlobalState {
        parts = List.copyOf(parts);
        registers = List.copyOf(registers);
    }

    public GlobalState(List<List<Configuration>> parts, List<Sent> registers) {
        this(parts, registers, "");
    }

    /** The end of a run. */
    static GlobalState error(String problem) {
        return new GlobalState(List.of(List.of(Configuration.ERROR)), List.of(), problem);
    }

    public boolean isError() {
        return isError(parts);
    }

    public static boolean isError(List<List<Configuration>> parts) {
        return parts.stream().anyMatch(each -> each.contains(Configuration.ERROR));
    }
}
