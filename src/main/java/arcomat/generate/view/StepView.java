package arcomat.generate.view;

import java.util.List;

/**
 * A part at its place in the schedule, or parts in an array, one after the other.
 *
 * @param part with the index in brackets where it is in an array
 * @param call {@code step}, {@code act}, or empty where there is nothing to call
 * @param copies messages that the part gets right before
 * @param index variable of the loop; empty for a single part
 * @param first first value of the index
 * @param end the index stays below
 */
public record StepView(
        String part, String call, List<AssignmentView> copies, String index, int first, int end) {

    public static StepView once(String part, String call, List<AssignmentView> copies) {
        return new StepView(part, call, copies, "", 0, 1);
    }
}
