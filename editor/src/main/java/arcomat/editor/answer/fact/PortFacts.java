package arcomat.editor.answer.fact;

import arcomat.editor.answer.flow.PortConnections;
import arcomat.pipeline.recheck.ReadModels;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * What is known of a port: when it sends, whether it can be silent, and where it is connected.
 *
 * @param models it is in
 * @param place where it is named
 */
record PortFacts(ReadModels models, PortSymbol port, Span place) {

    /** Connections that are looked for; of a clock in a thousand parts nobody reads all. */
    private static final int MOST = 6;

    List<String> all() {
        List<String> facts = new ArrayList<>();
        owner().filter(each -> port.isOutput()).flatMap(this::delay).ifPresent(facts::add);
        if (port.isTotal()) {
            facts.add("total: a message in every slice");
        }
        List<ConnectorSymbol> some = new PortConnections(models).at(port).limit(MOST + 1).toList();
        connected("receives", some, ConnectorSymbol::target).ifPresent(facts::add);
        connected("sends", some, ConnectorSymbol::source).ifPresent(facts::add);
        if (some.size() > MOST) {
            facts.add("and others");
        }
        return facts;
    }

    /**
     * The component whose port it is here: an heir may have another delay. Empty where several
     * components have it and the place does not tell, and for automata in files of their own.
     */
    private Optional<ComponentSymbol> owner() {
        List<ComponentSymbol> all = new PortConnections(models).withPort(port);
        return all.size() == 1
                ? Optional.of(all.get(0))
                : all.stream()
                        .filter(each -> isIn(each.node().span()))
                        .min(Comparator.comparing(each -> length(each.node().span())));
    }

    private static int length(Span span) {
        return span.end() - span.start();
    }

    /** Behind a dot it is the port of a part. */
    private boolean isIn(Span whole) {
        boolean isOfAPart =
                place.start() > 0 && place.file().text().charAt(place.start() - 1) == '.';
        return !isOfAPart && whole.isAround(place);
    }

    private Optional<String> delay(ComponentSymbol owner) {
        if (owner.isEventDriven()) {
            return Optional.of("untimed: sent with the event that is handled");
        }
        int delay = models.workspace().delays().effective(owner, port);
        if (owner.isDecomposed()) {
            return owner.connectorTo(port.name())
                    .filter(ConnectorSymbol::isResolved)
                    .map(sender -> "delay " + delay + ": " + origin(sender));
        }
        return Optional.of(
                delay == 0
                        ? "delay 0: a reaction is sent in the same slice"
                        : "delay 1: a reaction is sent one slice later");
    }

    private static String origin(ConnectorSymbol sender) {
        return sender.source().instance().isPresent()
                ? "that of the part that sends it"
                : "an input is passed on";
    }

    private Optional<String> connected(
            String verb,
            List<ConnectorSymbol> connectors,
            Function<ConnectorSymbol, ConnectorSymbol.End> end) {
        List<String> shown =
                connectors.stream()
                        .limit(MOST)
                        .filter(each -> PortConnections.isAt(end.apply(each), port))
                        .map(PortFacts::shown)
                        .distinct()
                        .toList();
        return shown.isEmpty()
                ? Optional.empty()
                : Optional.of(verb + ": " + String.join(", ", shown));
    }

    private static String shown(ConnectorSymbol connector) {
        return Markdown.word(connector.source().key() + " -> " + connector.target().key())
                + " in "
                + Markdown.word(connector.owner().qualifiedName());
    }
}
