package arcomat.sim.trace;

import java.util.List;

/** What a program did, cycle by cycle. */
public record Trace(List<Cycle> cycles) {
    public Trace {
        cycles = List.copyOf(cycles);
    }

    /** Everything in order. */
    public List<Event> events() {
        return cycles.stream().flatMap(cycle -> cycle.events().stream()).toList();
    }
}
