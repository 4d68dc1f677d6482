package arcomat.generate.view;

import arcomat.generate.language.TypeName;
import arcomat.generate.view.CompositeView.LoopsView;
import arcomat.generate.view.CompositeView.PartView;
import arcomat.generate.view.CompositeView.StepView;
import arcomat.generate.view.HeadView.AssignmentView;

import java.util.List;

/**
 * Some parts of a large composite, or some sections of them.
 *
 * @param head of the composite
 * @param self the section's own class
 * @param members parts in the order of their schedule, or sections
 * @param fixed flags of messages that are always there
 * @param sensors members that have a method {@code sense}
 * @param knowers members that are sections
 * @param known copies of what is known when a slice starts
 * @param steps the schedule
 * @param loops over arrays of parts
 * @param whole name of the field that leads to the composite
 */
public record PartsView(
        HeadView head,
        TypeName self,
        List<PartView> members,
        List<AssignmentView> fixed,
        List<String> sensors,
        List<String> knowers,
        List<AssignmentView> known,
        List<StepView> steps,
        String whole,
        LoopsView loops,
        boolean checks) {}
