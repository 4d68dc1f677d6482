package arcomat.editor.answer.fact;

import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Status;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Node;
import arcomat.tree.Unit;

import org.eclipse.lsp4j.InlayHint;
import org.eclipse.lsp4j.InlayHintKind;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What an editor shows inside of a text, though it is not written there: which parameter an
 * argument is for, which port of a part a connector ends at that names the part alone, and what the
 * parts make of the outputs of a decomposed component, its delay and whether it is ever silent.
 */
public final class InlineFacts {
    private final Span wanted;
    private final View view;
    private final List<InlayHint> hints = new ArrayList<>();

    private InlineFacts(View view, Span wanted) {
        this.view = view;
        this.wanted = wanted;
    }

    public static List<InlayHint> in(View view, Range range) {
        InlineFacts facts = new InlineFacts(view, Positions.span(view.file(), range));
        view.parsed().readable().ifPresent(facts::addAll);
        return facts.hints;
    }

    private void addAll(Unit unit) {
        view.models().workspace().components().stream()
                .filter(each -> each.unit() == unit)
                .forEach(this::add);
        view.models().workspace().testSuites().stream()
                .filter(each -> each.unit() == unit)
                .forEach(this::add);
    }

    private void add(ComponentSymbol component) {
        Node last = null;
        for (InstanceSymbol part : component.ownInstances()) {
            if (part.node() != last) {
                addArguments(part.arguments());
            }
            last = part.node();
        }
        component.connectors().stream()
                .filter(each -> each.owner() == component)
                .forEach(this::addPorts);
        addArguments(component.signature().superArguments());
        if (component.isDecomposed() && !component.isEventDriven()) {
            component.signature().ownPorts().stream()
                    .filter(PortSymbol::isOutput)
                    .forEach(port -> addOutput(component, port));
        }
    }

    private void add(TestSuiteSymbol suite) {
        addArguments(suite.arguments());
    }

    /** Of those that do not say it themselves. */
    private void addArguments(List<GivenArgument> arguments) {
        for (GivenArgument argument : arguments) {
            Span span = argument.node().span();
            String name = argument.parameter().map(ParameterSymbol::name).orElse(span.text());
            if (argument.node().name().isEmpty() && !span.text().equals(name)) {
                add(span.start(), name + ":", InlayHintKind.Parameter);
            }
        }
    }

    /** One that leads to several receivers has its source once in the text. */
    private void addPorts(ConnectorSymbol connector) {
        addPort(connector.source());
        addPort(connector.target());
    }

    /** Who takes the hint over has the port written. */
    private void addPort(End end) {
        if (end.status() != Status.COMPLETED
                || !end.span().file().equals(view.file())
                || hints.stream().anyMatch(each -> isAt(end.span().end(), each))) {
            return;
        }
        String port = "." + end.port().orElseThrow().name();
        add(end.span().end(), port, InlayHintKind.Parameter)
                .ifPresent(
                        hint -> {
                            Position place = hint.getPosition();
                            hint.setTextEdits(List.of(new TextEdit(new Range(place, place), port)));
                            hint.setPaddingRight(false);
                        });
    }

    /** Elements of an array are declared in one place. */
    private boolean isThere(int offset, String label) {
        return hints.stream()
                .anyMatch(each -> isAt(offset, each) && each.getLabel().getLeft().equals(label));
    }

    private boolean isAt(int offset, InlayHint hint) {
        return hint.getPosition().equals(Positions.position(view.file(), offset));
    }

    /** Where no part sends it there is nothing to tell. */
    private void addOutput(ComponentSymbol component, PortSymbol port) {
        Optional<ConnectorSymbol> sender =
                component.connectorTo(port.name()).filter(ConnectorSymbol::isResolved);
        sender.flatMap(each -> each.source().port())
                .ifPresent(
                        source -> {
                            int delay =
                                    view.models().workspace().delays().effective(component, port);
                            String silent = source.isTotal() && !port.isTotal() ? ", total" : "";
                            add(
                                    port.nameSpan().end(),
                                    "delay " + delay + silent,
                                    InlayHintKind.Type);
                        });
    }

    /** Empty where nobody asked for that place. */
    private Optional<InlayHint> add(int offset, String label, InlayHintKind kind) {
        if (offset < wanted.start() || wanted.end() < offset || isThere(offset, label)) {
            return Optional.empty();
        }
        InlayHint hint =
                new InlayHint(Positions.position(view.file(), offset), Either.forLeft(label));
        hint.setKind(kind);
        hint.setPaddingLeft(kind == InlayHintKind.Type);
        hint.setPaddingRight(kind == InlayHintKind.Parameter);
        hints.add(hint);
        return Optional.of(hint);
    }
}
