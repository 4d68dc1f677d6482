package arcomat.generate.view;

import java.util.List;

/**
 * What happens where no transition is enabled.
 *
 * @param kind {@code chaos}, {@code output}, {@code ignore} or {@code error}
 * @param reachable whether the code can come here at all
 */
public record CompletionView(String kind, List<AssignmentView> assignments, boolean reachable) {}
