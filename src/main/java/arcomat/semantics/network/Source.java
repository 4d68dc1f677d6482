package arcomat.semantics.network;

import arcomat.model.Port;

import java.util.function.Function;
import java.util.function.Supplier;

/** Where the messages on a port come from, within one composite component. */
public sealed interface Source {
    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Function<FromOutside, R> outside, Function<FromNode, R> node, Supplier<R> none);

    /** An input port of the composite itself. */
    record FromOutside(Port port) implements Source {
        @Override
        public <R> R match(
                Function<FromOutside, R> outside, Function<FromNode, R> node, Supplier<R> none) {
            return outside.apply(this);
        }
    }

    /**
     * An output port of a node.
     *
     * @param node position in {@link Composition#nodes}
     * @param fresh whether the message is computed during the slice, by an automaton whose port has
     *     delay 0, so that the sender has to be evaluated first. Otherwise it is known when the
     *     slice starts: it comes from a register, or a platform component has sampled it.
     */
    record FromNode(int node, Port port, boolean fresh) implements Source {
        @Override
        public <R> R match(
                Function<FromOutside, R> outside, Function<FromNode, R> node, Supplier<R> none) {
            return node.apply(this);
        }
    }

    /** No sender: there is never a message. */
    record Unconnected() implements Source {
        @Override
        public <R> R match(
                Function<FromOutside, R> outside, Function<FromNode, R> node, Supplier<R> none) {
            return none.get();
        }
    }
}
