package arcomat.pipeline.generate;

import java.util.List;
import java.util.Optional;

/**
 * Code that is asked for.
 *
 * @param target a shipped target, or a folder of templates
 * @param out the folder to be written, as a whole
 * @param main the only component that gets a program; empty for all that are to be deployed
 * @param randomChoice whether the code draws where the model leaves a choice; else it takes the
 *     first alternative in text order
 * @param monitors requirements that programs watch themselves for, as written
 */
public record GenerationRequest(
        String target,
        String out,
        Optional<String> main,
        boolean randomChoice,
        List<String> monitors) {
    public GenerationRequest {
        monitors = List.copyOf(monitors);
    }
}
