package arcomat.generate.view;

import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.generate.view.HeadView.FieldView;

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
 * @param silences what a slice assigns before anything else, so that outputs carry no message
 *     unless a transition or the completion sends one
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
        List<AssignmentView> silences,
        CompletionView completion,
        String state,
        String taken,
        boolean traced,
        boolean checks,
        boolean wide) {
    /** A state: its named constant, its code and its name in the model. */
    public record StateNameView(String constant, int code, String name) {}

    /**
     * States whose transitions share a method.
     *
     * @param number position among the sections; section k has the states from k * size on
     * @param draws whether a transition may have to be drawn
     */
    public record SectionView(String method, int number, boolean draws, List<StateView> states) {}

    /**
     * A state with what leads out of it.
     *
     * @param label constant or code
     * @param name in the model
     * @param chooses whether more than one transition may be enabled and one of them is to be drawn
     * @param wide whether there are more than 31 of them
     * @param last whether the last transition is always enabled where no earlier one is
     * @param chunks where there are too many transitions for one method: all of them, in methods
     * @param error message where no transition is enabled and that is forbidden, a literal of the
     *     target; empty otherwise
     */
    public record StateView(
            String label,
            String name,
            List<TransitionView> transitions,
            boolean chooses,
            boolean wide,
            boolean last,
            List<ChunkView> chunks,
            String error) {}

    /**
     * A transition.
     *
     * @param index position in the automaton
     * @param comment line and text in the model
     * @param condition empty where it holds always
     * @param locals values to be computed before any assignment
     * @param assignments in an order that needs no further locals; of outputs, those that carry a
     *     message, and in the beginning all
     * @param messages event-driven: methods that send, with what they send, before any assignment
     * @param target constant or code of the next state, empty where the state stays
     * @param mark for the line that is reached exactly where the transition has been taken; the
     *     file does not have it
     * @param statements what is done, where it is written as statements; there are neither locals
     *     nor messages nor assignments then
     */
    public record TransitionView(
            int index,
            String comment,
            String condition,
            List<FieldView> locals,
            List<AssignmentView> messages,
            List<AssignmentView> assignments,
            String target,
            String mark,
            StatementsView statements) {
        /** One that is not written as statements. */
        public TransitionView(
                int index,
                String comment,
                String condition,
                List<FieldView> locals,
                List<AssignmentView> messages,
                List<AssignmentView> assignments,
                String target,
                String mark) {
            this(
                    index,
                    comment,
                    condition,
                    locals,
                    messages,
                    assignments,
                    target,
                    mark,
                    StatementsView.NONE);
        }
    }

    /**
     * Statements, line by line.
     *
     * @param label names the place behind them, where they may stop before anything is done; empty
     *     where they do not
     * @param way local variable with the number of the transition that they stand for; empty where
     *     that is known
     */
    public record StatementsView(List<LineView> lines, String label, String way) {
        public static final StatementsView NONE = new StatementsView(List.of(), "", "");

        public StatementsView {
            lines = List.copyOf(lines);
        }
    }

    /**
     * A line of statements.
     *
     * @param kind {@code declare}, {@code assign}, {@code call}, {@code if}, {@code elseif}, {@code
     *     else}, {@code end}, {@code stop} or {@code count}
     * @param depth of choices that it stands in
     * @param type of what is declared; else empty
     * @param target what gets a value, or is called with it
     * @param value the value, or the condition
     */
    public record LineView(String kind, int depth, String type, String target, String value) {}

    /**
     * Some transitions of a state that has too many for one method.
     *
     * @param last whether the last transition is always enabled where no earlier one is
     */
    public record ChunkView(String method, List<TransitionView> transitions, boolean last) {}

    /**
     * A part of a condition that is too long for one method.
     *
     * @param judged whether it says what is known of it, or else whether it holds
     * @param wrong what is known of it where it goes wrong; empty where that is an error
     */
    public record ConditionView(String method, String condition, boolean judged, String wrong) {}

    /**
     * What happens where no transition is enabled.
     *
     * @param kind {@code chaos}, {@code output}, {@code ignore} or {@code error}
     * @param reachable whether the code can come here at all
     */
    public record CompletionView(
            String kind, List<AssignmentView> assignments, boolean reachable) {}
}
