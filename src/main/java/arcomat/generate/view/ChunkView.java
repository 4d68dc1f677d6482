package arcomat.generate.view;

import java.util.List;

/**
 * Some transitions of a state that has too many for one method.
 *
 * @param last whether the last transition is always enabled where no earlier one is
 */
public record ChunkView(String method, List<TransitionView> transitions, boolean last) {}
