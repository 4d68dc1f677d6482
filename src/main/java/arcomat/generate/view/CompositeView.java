package arcomat.generate.view;

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
        boolean checks) {}
