package arcomat.generate.view;

import arcomat.generate.view.CompositeView.PartView;
import arcomat.generate.view.EventView.EventPortView;

import java.util.List;

/**
 * An event-driven composite, or an event-driven platform component, which has no members.
 *
 * @param members in the order in which they are visited
 */
public record NetworkView(
        HeadView head,
        List<MemberView> members,
        List<RouteView> inputs,
        List<EventPortView> outputs,
        String border,
        boolean checks) {

    /** A part, and where the messages on its outputs go. */
    public record MemberView(PartView part, boolean reacts, List<RouteView> routes) {}

    /**
     * The way of the messages on a port.
     *
     * @param calls methods that take the message, in order; qualified by the part for inputs of
     *     parts
     */
    public record RouteView(EventPortView port, List<String> calls) {}
}
