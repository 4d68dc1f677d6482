package arcomat.editor.answer.completion;

import arcomat.source.ArrayNames;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.names.TypeSymbol;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The ends that a connector can have: senders before the arrow; behind it receivers that have no
 * sender yet, of the sender's type if there are such.
 *
 * @param place what is around the place
 */
record KnownEnds(WritingPlace place) {
    private static final String ARROW = "->";

    List<Proposal> ends() {
        return place.component()
                .map(component -> place.says(ARROW) ? receivers(component) : senders(component))
                .orElse(List.of());
    }

    /** The part whose port is being written, if one is. */
    private Optional<InstanceSymbol> part(ComponentSymbol component) {
        return place.word(1).equals(".")
                ? oneOf(place.name(2), component::instance)
                : Optional.empty();
    }

    /** Of a whole array, its first element: all have the same ports and the same type. */
    private static <T> Optional<T> oneOf(String name, Function<String, Optional<T>> find) {
        return find.apply(name).or(() -> find.apply(ArrayNames.element(name, 0)));
    }

    /** Elements, and the arrays that they are of. */
    private static List<Proposal> ports(List<PortSymbol> ports, Collection<PortSymbol> all) {
        List<String> names = all.stream().map(PortSymbol::name).toList();
        return Stream.concat(
                        Proposal.arrays(ports.stream(), names, PortSymbol::name, Proposal::of)
                                .stream(),
                        ports.stream().map(port -> Proposal.of(port)))
                .toList();
    }

    private static List<Proposal> parts(
            List<InstanceSymbol> parts, Collection<InstanceSymbol> all) {
        List<String> names = all.stream().map(InstanceSymbol::name).toList();
        return Stream.concat(
                        Proposal.arrays(parts.stream(), names, InstanceSymbol::name, Proposal::of)
                                .stream(),
                        parts.stream().map(part -> Proposal.of(part)))
                .toList();
    }

    private List<Proposal> senders(ComponentSymbol component) {
        if (place.word(1).equals(".")) {
            return part(component).stream()
                    .flatMap(part -> ports(senders(part), part.ports()).stream())
                    .toList();
        }
        List<Proposal> own =
                ports(
                        component.ports().stream().filter(PortSymbol::isInput).toList(),
                        component.ports());
        List<Proposal> parts =
                parts(
                        component.instances().stream()
                                .filter(part -> !senders(part).isEmpty())
                                .toList(),
                        component.instances());
        return Stream.concat(own.stream(), parts.stream()).toList();
    }

    private List<Proposal> receivers(ComponentSymbol component) {
        Optional<TypeSymbol> type = sender(component).map(PortSymbol::type);
        if (place.word(1).equals(".")) {
            return part(component).stream()
                    .flatMap(
                            part ->
                                    ports(fitting(free(component, part), type), part.ports())
                                            .stream())
                    .toList();
        }
        List<Proposal> proposals = new ArrayList<>();
        List<PortSymbol> own =
                component.ports().stream()
                        .filter(PortSymbol::isOutput)
                        .filter(port -> component.connectorTo(port.name()).isEmpty())
                        .toList();
        proposals.addAll(ports(fitting(own, type), component.ports()));
        proposals.addAll(
                parts(
                        component.instances().stream()
                                .filter(part -> !free(component, part).isEmpty())
                                .toList(),
                        component.instances()));
        return proposals;
    }

    private static List<PortSymbol> senders(InstanceSymbol part) {
        return part.ports().stream().filter(PortSymbol::isOutput).toList();
    }

    private static List<PortSymbol> free(ComponentSymbol component, InstanceSymbol part) {
        return part.ports().stream()
                .filter(PortSymbol::isInput)
                .filter(port -> component.connectorTo(part.name() + "." + port.name()).isEmpty())
                .toList();
    }

    /** Those of a type; all where there is none of it, since a type may be what is to be mended. */
    private static List<PortSymbol> fitting(List<PortSymbol> ports, Optional<TypeSymbol> type) {
        List<PortSymbol> fitting =
                ports.stream()
                        .filter(
                                port ->
                                        type.isEmpty()
                                                || port.type().base().equals(type.get().base()))
                        .toList();
        return fitting.isEmpty() ? ports : fitting;
    }

    /** What stands before the arrow, behind the word that begins the connector. */
    private Optional<PortSymbol> sender(ComponentSymbol component) {
        List<String> words = place.caret().statement();
        if (!words.contains(ARROW)) {
            return Optional.empty();
        }
        int before = words.size() - words.indexOf(ARROW) + 1;
        int dot = before + (place.word(before).equals("]") ? 4 : 1);
        return place.word(dot).equals(".")
                ? oneOf(place.name(dot + 1), component::instance)
                        .flatMap(part -> oneOf(place.name(before), part::port))
                : oneOf(place.name(before), component::port);
    }
}
