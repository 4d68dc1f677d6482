package arcomat.generate.view;

import java.util.List;

/**
 * A state with what leads out of it.
 *
 * @param label constant or code
 * @param name in the model
 * @param chooses whether more than one transition may be enabled and one of them is to be drawn
 * @param wide whether there are more than 31 of them
 * @param last whether the last transition is always enabled where no earlier one is
 * @param chunks where there are too many transitions for one method: all of them, in methods
 * @param error message where no transition is enabled and that is forbidden, a literal of the
 *     target; empty otherwise
 */
public record StateView(
        String label,
        String name,
        List<TransitionView> transitions,
        boolean chooses,
        boolean wide,
        boolean last,
        List<ChunkView> chunks,
        String error) {}
