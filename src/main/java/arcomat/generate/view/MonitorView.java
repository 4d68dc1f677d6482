package arcomat.generate.view;

import arcomat.generate.view.AtomicView.StateNameView;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.generate.view.HeadView.FieldView;

import java.util.List;

/**
 * A class that watches the ports of a component for one requirement.
 *
 * @param imports qualified names
 * @param title the component, with the automaton where it is one of several
 * @param requirement a literal that names the automaton and its line
 * @param constants with a literal as value, or none where the constructor computes it
 * @param constructed what the constructor computes
 * @param states empty where there are too many for named constants
 * @param stateNames literals; empty where there are too many
 * @param variables with their first values
 * @param initials alternatives
 * @param sections whose transitions are together all transitions
 * @param completion what happens where no transition is enabled; none where that is forbidden
 * @param state parameter with the code of the state
 * @param spelt outputs whose messages are no numbers
 * @param events what it asks where it watches events; none where it watches slices
 */
public record MonitorView(
        HeadView head,
        List<String> imports,
        String title,
        String requirement,
        List<FieldView> constants,
        List<AssignmentView> constructed,
        List<StateNameView> states,
        List<String> stateNames,
        List<SeenView> outputs,
        List<FieldView> variables,
        List<GoView> initials,
        List<MonitorSectionView> sections,
        List<GoView> completion,
        String state,
        List<SpeltView> spelt,
        List<EventsView> events) {

    /**
     * What is particular about events.
     *
     * @param present condition that a port has an event
     */
    public record EventsView(String present) {}

    /**
     * How a message is told.
     *
     * @param port position of the output
     * @param text computed from the code {@code message}
     */
    public record SpeltView(int port, String text) {}

    /**
     * What an output shows.
     *
     * @param literal its name
     * @param present condition that there is a message; empty where there always is one
     * @param message the message as a number, or as an object
     */
    public record SeenView(String literal, boolean delayed, String present, String message) {}

    /**
     * A way to begin or to go on.
     *
     * @param comment line and text in the model
     * @param condition empty where it holds always
     * @param cause a literal that names it in messages; the kind of a completion
     * @param target constant or code of the next state
     * @param values variables that are different afterwards
     * @param promises what is to be seen; nothing on outputs without one
     * @param checked whether it may go wrong
     * @param alone whether none of those after it can be a way to go on as well
     */
    public record GoView(
            String comment,
            String condition,
            String cause,
            String target,
            List<SetView> values,
            List<PromiseView> promises,
            boolean checked,
            boolean alone) {}

    /** A variable, by position, that gets a value. */
    public record SetView(int variable, String value) {}

    /**
     * What is to be seen on an output.
     *
     * @param port its position
     * @param any whether it is some message, whichever
     * @param open whether it may be no message as well
     */
    public record PromiseView(int port, List<String> messages, boolean any, boolean open) {}

    /**
     * Some states with some of their transitions, few enough for a method.
     *
     * @param method empty where one section holds all
     * @param variables those that are read, with their value out of what is kept
     */
    public record MonitorSectionView(
            String method, List<FieldView> variables, List<MonitorStateView> states) {}

    /** A state with transitions out of it. */
    public record MonitorStateView(String label, String name, List<GoView> transitions) {}
}
