package arcomat.generate.view;

import java.util.List;

/**
 * A component made of parts.
 *
 * @param members the parts in the order of their schedule
 * @param fixed flags of messages that are always there
 * @param sensors parts that have a method {@code sense}
 * @param sensed outputs that show what sensors inside have sampled
 * @param known copies of what is known when a slice starts
 * @param steps the schedule
 * @param registers outputs that show in the next slice what was sent in this one
 * @param fresh outputs that show what was sent in the same slice
 * @param checks whether computing an argument may go wrong
 */
public record CompositeView(
        HeadView head,
        List<PartView> members,
        List<AssignmentView> fixed,
        List<String> sensors,
        List<AssignmentView> sensed,
        List<AssignmentView> known,
        List<StepView> steps,
        List<AssignmentView> registers,
        List<AssignmentView> fresh,
        boolean checks) {}
