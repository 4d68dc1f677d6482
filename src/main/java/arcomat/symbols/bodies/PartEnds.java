package arcomat.symbols.bodies;

import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Ends;
import arcomat.symbols.bodies.ConnectorSymbol.Status;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.TypeRules;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Ends of connectors that name a part and leave out its port, as in {@code connect speed -> motor}.
 * The port is the one that fits and has the name of that at the other end; where none has, it is
 * the only one that fits.
 */
final class PartEnds {
    private PartEnds() {}

    /**
     * Those of one connector, which has one source, with their ports; as they are where it is not
     * clear which ports are meant.
     */
    static List<Ends> complete(List<Ends> written) {
        List<Ends> completed = written.stream().map(PartEnds::complete).toList();
        long sources = completed.stream().map(each -> each.source().key()).distinct().count();
        return sources == 1 ? completed : written;
    }

    private static Ends complete(Ends written) {
        if (!written.source().namesPart() && !written.target().namesPart()) {
            return written;
        }
        List<Ends> fitting = candidates(written);
        List<Ends> namedAlike = fitting.stream().filter(PartEnds::areNamedAlike).toList();
        List<Ends> meant = namedAlike.isEmpty() ? fitting : namedAlike;
        return meant.size() == 1 ? meant.get(0) : written;
    }

    /** All pairs of ports that could be connected; the names of ports make no difference. */
    static List<Ends> candidates(Ends written) {
        List<End> receivers = ends(written.target()).filter(End::isReceiver).toList();
        return ends(written.source())
                .filter(End::isSender)
                .flatMap(sender -> receivers.stream().map(receiver -> new Ends(sender, receiver)))
                .filter(PartEnds::fit)
                .toList();
    }

    private static Stream<End> ends(End written) {
        if (written.isResolved()) {
            return Stream.of(written);
        }
        return written.namesPart()
                ? written.instance().stream()
                        .flatMap(
                                part -> part.ports().stream().map(port -> end(written, part, port)))
                : Stream.empty();
    }

    private static End end(End written, InstanceSymbol part, PortSymbol port) {
        return new End(
                written.span(),
                part.name() + "." + port.name(),
                Status.COMPLETED,
                Optional.of(part),
                Optional.of(port));
    }

    private static boolean fit(Ends ends) {
        PortSymbol from = ends.source().port().orElseThrow();
        PortSymbol to = ends.target().port().orElseThrow();
        return !from.type().isErroneous()
                && !to.type().isErroneous()
                && !ends.source().key().equals(ends.target().key())
                && TypeRules.fits(from.type(), to.type());
    }

    private static boolean areNamedAlike(Ends ends) {
        return ends.source()
                .port()
                .map(PortSymbol::name)
                .equals(ends.target().port().map(PortSymbol::name));
    }
}
