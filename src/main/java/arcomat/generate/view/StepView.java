package arcomat.generate.view;

import java.util.List;

/**
 * A part at its place in the schedule.
 *
 * @param copies messages sent earlier in the same slice that the part reads
 * @param call {@code step}, {@code act}, or empty where the part only senses
 */
public record StepView(String part, String call, List<AssignmentView> copies) {}
