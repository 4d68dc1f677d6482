package arcomat.generate.view;

import java.util.List;

/**
 * A transition.
 *
 * @param index position in the automaton
 * @param comment line and text in the model
 * @param condition empty where it holds always
 * @param locals values to be computed before any assignment
 * @param assignments in an order that needs no further locals
 * @param messages event-driven: methods that send, with what they send, before any assignment
 * @param target constant or code of the next state, empty where the state stays
 */
public record TransitionView(
        int index,
        String comment,
        String condition,
        List<FieldView> locals,
        List<AssignmentView> messages,
        List<AssignmentView> assignments,
        String target) {}
