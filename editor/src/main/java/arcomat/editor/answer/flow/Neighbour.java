package arcomat.editor.answer.flow;

import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.occurrences.Referent;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What is next to something in a hierarchy.
 *
 * @param place where that is written: an end of a connector, or the name of a part
 */
record Neighbour(Referent referent, Span place) {

    /** From where messages come, or what something is a part of, with all places of each. */
    static Map<Referent, List<Span>> before(Referent referent, OpenModels models) {
        return grouped(
                switch (referent.kind()) {
                    case COMPONENT -> wholes((Referent.Component) referent, models);
                    case PART -> senders(((Referent.Part) referent).symbol());
                    case PORT ->
                            ends(
                                    new PortConnections(models)
                                            .to(((Referent.Port) referent).symbol()),
                                    ConnectorSymbol::source);
                    default -> Stream.empty();
                });
    }

    /** Where messages go, or the parts of something. */
    static Map<Referent, List<Span>> behind(Referent referent, OpenModels models) {
        return grouped(
                switch (referent.kind()) {
                    case COMPONENT -> parts((Referent.Component) referent, models);
                    case PART -> receivers(((Referent.Part) referent).symbol());
                    case PORT ->
                            ends(
                                    new PortConnections(models)
                                            .from(((Referent.Port) referent).symbol()),
                                    ConnectorSymbol::target);
                    default -> Stream.empty();
                });
    }

    private static Map<Referent, List<Span>> grouped(Stream<Neighbour> neighbours) {
        return neighbours.collect(
                Collectors.groupingBy(
                        Neighbour::referent,
                        LinkedHashMap::new,
                        Collectors.mapping(Neighbour::place, Collectors.toList())));
    }

    private static Stream<Neighbour> wholes(Referent.Component component, OpenModels models) {
        return symbol(component, models)
                .flatMap(each -> new PortConnections(models).parts(each).stream())
                .map(
                        part ->
                                new Neighbour(
                                        new Referent.Component(part.owner().signature()),
                                        part.nameSpan()));
    }

    private static Stream<Neighbour> parts(Referent.Component component, OpenModels models) {
        return symbol(component, models)
                .flatMap(each -> each.instances().stream())
                .flatMap(
                        part ->
                                part.component().stream()
                                        .map(
                                                type ->
                                                        new Neighbour(
                                                                new Referent.Component(
                                                                        type.signature()),
                                                                part.nameSpan())));
    }

    private static Stream<ComponentSymbol> symbol(Referent.Component component, OpenModels models) {
        return models.workspace().components().stream()
                .filter(each -> each.signature().equals(component.signature()));
    }

    private static Stream<Neighbour> senders(InstanceSymbol part) {
        return ends(connectors(part, ConnectorSymbol::target), ConnectorSymbol::source);
    }

    private static Stream<Neighbour> receivers(InstanceSymbol part) {
        return ends(connectors(part, ConnectorSymbol::source), ConnectorSymbol::target);
    }

    private static List<ConnectorSymbol> connectors(
            InstanceSymbol part, Function<ConnectorSymbol, End> end) {
        return part.owner().connectors().stream()
                .filter(ConnectorSymbol::isResolved)
                .filter(each -> end.apply(each).instance().filter(part::equals).isPresent())
                .toList();
    }

    private static Stream<Neighbour> ends(
            List<ConnectorSymbol> connectors, Function<ConnectorSymbol, End> end) {
        return connectors.stream().map(end).map(each -> new Neighbour(referent(each), each.span()));
    }

    private static Referent referent(End end) {
        return end.instance()
                .<Referent>map(Referent.Part::new)
                .orElseGet(() -> new Referent.Port(end.port().orElseThrow()));
    }
}
