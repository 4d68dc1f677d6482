package arcomat.generate.view;

import java.util.List;

/**
 * A component with an automaton.
 *
 * @param constants with a literal as value
 * @param variables with a literal as first value, or none where the constructor computes it
 * @param constructed what the constructor computes, constants first
 * @param states empty where there are too many for named constants
 * @param initials alternatives
 * @param switches whether there is more than one state
 * @param sectionSize number of states per section, where there is more than one section
 * @param conditions methods that conditions of transitions call
 * @param state field with the code of the state
 * @param taken field with the index of the transition last taken
 * @param traced whether somebody looks at it
 * @param checks whether an operation may go wrong
 * @param wide whether sets of enabled transitions need more than 31 bits
 */
public record AtomicView(
        HeadView head,
        List<FieldView> constants,
        List<FieldView> variables,
        List<AssignmentView> constructed,
        List<StateNameView> states,
        List<TransitionView> initials,
        boolean switches,
        List<SectionView> sections,
        int sectionSize,
        List<ConditionView> conditions,
        CompletionView completion,
        String state,
        String taken,
        boolean traced,
        boolean checks,
        boolean wide) {}
