package arcomat.sim.script;

import java.util.List;
import java.util.Optional;

/**
 * A script that was read.
 *
 * @param script absent if there are errors
 * @param errors one per broken line at most, in the order of lines
 */
public record ParsedScript(Optional<Script> script, List<ScriptError> errors) {
    public ParsedScript {
        errors = List.copyOf(errors);
    }
}
