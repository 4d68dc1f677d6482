package arcomat.editor.answer.completion;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.names.TypeSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
        return place.word(1).equals(".") ? component.instance(place.word(2)) : Optional.empty();
    }

    private List<Proposal> senders(ComponentSymbol component) {
        if (place.word(1).equals(".")) {
            return part(component).stream()
                    .flatMap(part -> part.ports().stream())
                    .filter(PortSymbol::isOutput)
                    .map(port -> Proposal.of(port))
                    .toList();
        }
        Stream<Proposal> own =
                component.ports().stream()
                        .filter(PortSymbol::isInput)
                        .map(port -> Proposal.of(port));
        Stream<Proposal> parts =
                component.instances().stream()
                        .filter(part -> part.ports().stream().anyMatch(PortSymbol::isOutput))
                        .map(part -> Proposal.of(part));
        return Stream.concat(own, parts).toList();
    }

    private List<Proposal> receivers(ComponentSymbol component) {
        Optional<TypeSymbol> type = sender(component).map(PortSymbol::type);
        if (place.word(1).equals(".")) {
            return part(component).stream()
                    .flatMap(part -> fitting(free(component, part), type).stream())
                    .map(port -> Proposal.of(port))
                    .toList();
        }
        List<Proposal> proposals = new ArrayList<>();
        List<PortSymbol> own =
                component.ports().stream()
                        .filter(PortSymbol::isOutput)
                        .filter(port -> component.connectorTo(port.name()).isEmpty())
                        .toList();
        fitting(own, type).forEach(port -> proposals.add(Proposal.of(port)));
        component.instances().stream()
                .filter(part -> !free(component, part).isEmpty())
                .forEach(part -> proposals.add(Proposal.of(part)));
        return proposals;
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
        int arrow = words.indexOf(ARROW);
        if (arrow >= 3 && words.get(arrow - 2).equals(".")) {
            String port = words.get(arrow - 1);
            return component.instance(words.get(arrow - 3)).flatMap(part -> part.port(port));
        }
        return arrow >= 1 ? component.port(words.get(arrow - 1)) : Optional.empty();
    }
}
