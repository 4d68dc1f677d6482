package arcomat.generate.view;

import arcomat.generate.view.HeadView.PortView;

import java.util.List;

/**
 * An event-driven component with an automaton.
 *
 * @param capacity how many events may wait
 * @param waiting field with the ports of the events that wait
 * @param oldest field with the place of the oldest of them
 * @param count field with their number
 * @param border field for who sees what is sent
 */
public record EventView(
        HeadView head,
        AtomicView automaton,
        List<EventPortView> inputs,
        List<EventPortView> outputs,
        int capacity,
        String waiting,
        String oldest,
        String count,
        String border) {
    /**
     * A port of an event-driven component.
     *
     * @param method takes a message in, or sends one
     * @param first of a latched port, what it holds before its first message; else empty
     * @param buffer field with the messages that wait; empty for outputs and latched ports
     * @param number of the port among the inputs
     * @param literal its name in the model as a literal of the target
     */
    public record EventPortView(
            PortView port,
            String method,
            String first,
            String buffer,
            boolean latched,
            int number,
            String literal) {}
}
