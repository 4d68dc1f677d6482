package arcomat.generate.view;

import arcomat.generate.view.CompositeView.PartView;
import arcomat.generate.view.EventView.EventPortView;

import java.util.List;

/**
 * An event-driven composite, or an event-driven platform component, which has no members.
 *
 * @param members in the order in which they are visited; {@linkplain SubnetworkView sections} where
 *     there are too many parts for one class
 * @param shares of the receivers of messages that go to many
 */
public record NetworkView(
        HeadView head,
        List<MemberView> members,
        List<RouteView> inputs,
        List<EventPortView> outputs,
        List<ShareView> shares,
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

    /**
     * Some of the receivers of a message that has too many for one method.
     *
     * @param method that hands it to them
     * @param type of the message
     * @param calls methods that take it, in order
     */
    public record ShareView(String method, String type, List<String> calls) {}
}
