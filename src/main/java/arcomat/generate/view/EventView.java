package arcomat.generate.view;

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
        String border) {}
