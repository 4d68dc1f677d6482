package arcomat.generate.view;

import java.util.List;

/**
 * What loops over arrays of parts do besides the steps.
 *
 * @param fixed flags of messages that are always there
 * @param known copies of what is known when a slice starts
 * @param reordered whether receivers of delayed messages take their steps before the senders
 */
public record LoopsView(List<StepView> fixed, List<StepView> known, boolean reordered) {}
