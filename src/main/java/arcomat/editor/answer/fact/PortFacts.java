package arcomat.editor.answer.fact;

import arcomat.editor.answer.flow.Wiring;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * What is known of a port: when it sends, whether it can be silent, and where it is connected.
 *
 * @param models it is in
 */
record PortFacts(OpenModels models, PortSymbol port) {

    List<String> all() {
        List<String> facts = new ArrayList<>();
        owner().filter(each -> port.isOutput()).flatMap(this::delay).ifPresent(facts::add);
        if (port.isTotal()) {
            facts.add("total: a message in every slice");
        }
        List<ConnectorSymbol> all = new Wiring(models).at(port);
        connected("receives", all, ConnectorSymbol::target).ifPresent(facts::add);
        connected("sends", all, ConnectorSymbol::source).ifPresent(facts::add);
        return facts;
    }

    /** Empty for the ports of an automaton that has a file of its own. */
    private Optional<ComponentSymbol> owner() {
        return models.workspace().components().stream()
                .filter(each -> each.unit().file() == port.nameSpan().file())
                .filter(each -> each.signature().ownPorts().contains(port))
                .findFirst();
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
                        .filter(each -> Wiring.isAt(end.apply(each), port))
                        .map(PortFacts::shown)
                        .distinct()
                        .toList();
        return shown.isEmpty()
                ? Optional.empty()
                : Optional.of(verb + ": " + Enumeration.of(shown));
    }

    private static String shown(ConnectorSymbol connector) {
        return Markdown.word(connector.source().key() + " -> " + connector.target().key())
                + " in "
                + Markdown.word(connector.owner().qualifiedName());
    }
}
