package arcomat.generate.view;

import arcomat.generate.view.HeadView.AssignmentView;

import java.util.List;

/**
 * A component made of parts. Where there are too many for one class they live in {@linkplain
 * PartsView sections}, and those are the members.
 *
 * @param members parts in the order of their schedule, or sections
 * @param knowers sections that copy what is known when a slice starts
 * @param sensed outputs that show what sensors inside have sampled
 * @param registers outputs that show in the next slice what was sent in this one
 * @param fresh outputs that show what was sent in the same slice
 * @param loops over arrays of parts
 * @param checks whether computing an argument may go wrong
 */
public record CompositeView(
        HeadView head,
        List<PartView> members,
        List<AssignmentView> fixed,
        List<String> sensors,
        List<String> knowers,
        List<AssignmentView> sensed,
        List<AssignmentView> known,
        List<StepView> steps,
        List<AssignmentView> registers,
        List<AssignmentView> fresh,
        LoopsView loops,
        boolean checks) {
    /**
     * A part of a composite, or an array of parts.
     *
     * @param arguments of its constructor
     * @param length of the array; 0 for a single part
     * @param elements how the array is filled; empty for a single part
     */
    public record PartView(
            String type,
            String name,
            String arguments,
            String comment,
            int length,
            List<ElementsView> elements) {

        public static PartView single(String type, String name, String arguments, String comment) {
            return new PartView(type, name, arguments, comment, 0, List.of());
        }

        /**
         * Elements of an array that are constructed alike.
         *
         * @param place the element that is assigned to
         * @param index variable of the loop; empty for a single element
         * @param first first value of the index
         * @param end the index stays below
         */
        public record ElementsView(
                String place, String arguments, String index, int first, int end) {}
    }

    /**
     * A part at its place in the schedule, or parts in an array, one after the other.
     *
     * @param locals what a loop calls the elements of arrays that it works on, in the order in
     *     which they are declared; part and copies name them
     * @param part with the index in brackets where it is one element of an array
     * @param call {@code step}, {@code act}, or empty where there is nothing to call
     * @param copies messages that the part gets right before
     * @param index variable of the loop; empty for a single part
     * @param first first value of the index
     * @param end the index stays below
     */
    public record StepView(
            List<LocalView> locals,
            String part,
            String call,
            List<AssignmentView> copies,
            String index,
            int first,
            int end) {

        public static StepView once(String part, String call, List<AssignmentView> copies) {
            return new StepView(List.of(), part, call, copies, "", 0, 1);
        }
    }

    /**
     * A local variable that stands for an element of an array.
     *
     * @param place the element, with an index that depends on the loop's variable
     */
    public record LocalView(String type, String name, String place) {}

    /**
     * What loops over arrays of parts do besides the steps.
     *
     * @param fixed flags of messages that are always there
     * @param known copies of what is known when a slice starts
     * @param reordered whether receivers of delayed messages take their steps before the senders
     */
    public record LoopsView(List<StepView> fixed, List<StepView> known, boolean reordered) {}
}
