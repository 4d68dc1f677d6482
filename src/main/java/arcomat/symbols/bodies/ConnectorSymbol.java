package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;

import java.util.List;
import java.util.Optional;

/**
 * One sender connected to one receiver; a connector with several targets is several of these.
 *
 * @param node the connector, the simple connector, or the autoconnect statement behind it
 * @param span what to underline: the target as written, or the autoconnect statement
 */
public record ConnectorSymbol(
        ComponentSymbol owner,
        Origin origin,
        Node node,
        Span span,
        List<Stereotype> stereotypes,
        End source,
        End target) {
    public ConnectorSymbol {
        stereotypes = List.copyOf(stereotypes);
    }

    /** Who wrote it. */
    public enum Origin {
        EXPLICIT,
        SIMPLE,
        AUTOMATIC
    }

    /** Why an end does not resolve, or that it does. */
    public enum Status {
        RESOLVED,
        /** It names a part, and it is clear which of its ports is meant. */
        COMPLETED,
        /** Not {@code port} and not {@code instance.port}. */
        MALFORMED,
        /**
         * The component has no port of that name; {@code instance} tells if there is an instance.
         */
        NO_SUCH_PORT,
        /** The component has no instance of that name. */
        NO_SUCH_INSTANCE,
        /** The instance has no port of that name. */
        NO_SUCH_PORT_OF_INSTANCE,
        /** Each end names a whole array, and the arrays differ in size. */
        OTHER_SIZE,
        /** The type of the instance does not resolve, which is reported there. */
        EXCUSED
    }

    /**
     * One end.
     *
     * @param text {@code port} or {@code instance.port}; in brackets of an instance, with the name
     *     of the instance put before
     * @param instance empty for a port of the component itself
     * @param port with type arguments in place; present if resolved
     */
    public record End(
            Span span,
            String text,
            Status status,
            Optional<InstanceSymbol> instance,
            Optional<PortSymbol> port) {
        public boolean isResolved() {
            return status == Status.RESOLVED || status == Status.COMPLETED;
        }

        /** Whether it names a part, and it is not clear which of its ports is meant. */
        public boolean namesPart() {
            return status == Status.NO_SUCH_PORT && instance.isPresent();
        }

        /** Whether messages come out of it inside the component. */
        public boolean isSender() {
            return port.isPresent() && port.get().isInput() == instance.isEmpty();
        }

        /** Whether messages go into it inside the component. */
        public boolean isReceiver() {
            return port.isPresent() && port.get().isOutput() == instance.isEmpty();
        }

        /** Tells ports apart inside one component: {@code port} or {@code instance.port}. */
        public String key() {
            String name = port.map(PortSymbol::name).orElse(text);
            return instance.map(i -> i.name() + "." + name).orElse(name);
        }
    }

    /**
     * Both ends of a connector, which may be completed together.
     *
     * @param source where messages come from
     */
    public record Ends(End source, End target) {}

    /**
     * What may be meant where an end names a part and leaves out its port: all pairs of ports that
     * fit.
     */
    public List<Ends> candidates() {
        return PartEnds.candidates(new Ends(source, target));
    }

    public boolean isResolved() {
        return source.isResolved() && target.isResolved();
    }
}
