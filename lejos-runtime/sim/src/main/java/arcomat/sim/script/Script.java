package arcomat.sim.script;

import java.util.List;

/** Steps in the order of their times. */
public record Script(List<Step> steps) {
    public Script {
        steps = List.copyOf(steps);
    }
}
