package arcomat.editor.name;

import arcomat.source.Fix.TextEdit;
import arcomat.source.Span;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.names.Names;
import arcomat.symbols.occurrences.Referent;
import arcomat.tree.Component;
import arcomat.tree.Element;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Names that are nowhere written: to change one alone is to write it down. */
final class ImplicitNames {
    private ImplicitNames() {}

    /** What has to be written, of those that do not get their new names from their types. */
    static Map<Referent, TextEdit> written(Map<Referent, String> names) throws RenameRefused {
        Map<Referent, TextEdit> written = new LinkedHashMap<>();
        for (Map.Entry<Referent, String> each : names.entrySet()) {
            Referent referent = each.getKey();
            if (referent.isImplicit() && !each.getValue().equals(implicit(referent, names))) {
                Span place =
                        place(referent)
                                .orElseThrow(
                                        () ->
                                                new RenameRefused(
                                                        ("'%s' has its name from its type; write"
                                                                        + " a name there first")
                                                                .formatted(referent.name())));
                written.put(referent, new TextEdit(place, " " + each.getValue()));
            }
        }
        return written;
    }

    private static String implicit(Referent referent, Map<Referent, String> names) {
        return referent.typeReferent()
                .map(type -> names.getOrDefault(type, type.name()))
                .map(Names::implicit)
                .orElseGet(referent::name);
    }

    private static Optional<Span> place(Referent referent) {
        if (referent instanceof Referent.Port port) {
            Span type = port.symbol().typeNode().span();
            return Optional.of(type.file().span(type.end(), type.end()));
        }
        return referent instanceof Referent.Part part ? place(part.symbol()) : Optional.empty();
    }

    private static Optional<Span> place(InstanceSymbol part) {
        return part.node() instanceof Element.Subcomponent node
                ? behindLastWord(node.span(), ';', node.span().end() - 1)
                : beforeBody((Component) part.node());
    }

    /** Such a component has neither parameters nor type parameters. */
    private static Optional<Span> beforeBody(Component inner) {
        int head =
                Math.max(
                        inner.superComponent()
                                .map(type -> type.span().end())
                                .orElse(inner.name().span().end()),
                        inner.refined().stream()
                                .mapToInt(name -> name.span().end())
                                .max()
                                .orElse(0));
        return Optional.of(inner.span().file().span(head, head));
    }

    private static Optional<Span> behindLastWord(Span declaration, char end, int at) {
        String text = declaration.file().text();
        return at > declaration.start() && text.charAt(at) == end
                ? Optional.of(declaration.file().span(at, at))
                : Optional.empty();
    }
}
