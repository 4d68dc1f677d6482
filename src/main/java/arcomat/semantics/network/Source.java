package arcomat.semantics.network;

import arcomat.model.Port;

/** Where the messages on a port come from, within one composite component. */
public sealed interface Source {

    /** An input port of the composite itself. */
    record FromOutside(Port port) implements Source {}

    /**
     * An output port of a node.
     *
     * @param node position in {@link Composition#nodes}
     * @param fresh whether the message is computed during the slice, by an automaton whose port has
     *     delay 0, so that the sender has to be evaluated first. Otherwise it is known when the
     *     slice starts: it comes from a register, or a platform component has sampled it.
     */
    record FromNode(int node, Port port, boolean fresh) implements Source {}

    /** No sender: there is never a message. */
    record Unconnected() implements Source {}
}
