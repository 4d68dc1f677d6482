package arcomat.editor.answer.flow;

import arcomat.editor.answer.shape.ShortDescription;
import arcomat.editor.answer.shape.SymbolKinds;
import arcomat.editor.desk.View;
import arcomat.editor.name.Mentions;
import arcomat.editor.text.Positions;
import arcomat.source.Span;
import arcomat.symbols.occurrences.Referent;

import org.eclipse.lsp4j.CallHierarchyIncomingCall;
import org.eclipse.lsp4j.CallHierarchyItem;
import org.eclipse.lsp4j.CallHierarchyOutgoingCall;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;

import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What the protocol calls a hierarchy of calls. Of a port or a part, messages come in from senders
 * and go out to receivers; of a component, what has it for a part is before it, and its own parts
 * are behind it.
 */
public final class ConnectorHierarchy {
    private static final Set<Referent.Kind> KINDS =
            Set.of(Referent.Kind.COMPONENT, Referent.Kind.PART, Referent.Kind.PORT);

    private ConnectorHierarchy() {}

    public static List<CallHierarchyItem> prepare(View view, Position position) {
        String address = view.address(view.file().path());
        return Mentions.at(view, view.offset(position)).map(each -> each.referent().one()).stream()
                .filter(each -> KINDS.contains(each.kind()))
                .map(each -> item(each, view, address))
                .toList();
    }

    private static CallHierarchyItem item(Referent referent, View view, String address) {
        Span place = referent.declaration().orElseThrow();
        CallHierarchyItem item =
                new CallHierarchyItem(
                        referent.name(),
                        SymbolKinds.of(referent),
                        view.address(place.file().path()),
                        Positions.range(place),
                        Positions.range(place));
        item.setDetail(referent.match(new ShortDescription()));
        item.setData(HierarchyPlace.of(referent, address).written());
        return item;
    }

    public static List<CallHierarchyIncomingCall> incoming(View view, HierarchyPlace place) {
        return place.find(view.models()).stream()
                .flatMap(referent -> Neighbour.before(referent, view.models()).entrySet().stream())
                .map(
                        each ->
                                new CallHierarchyIncomingCall(
                                        item(each.getKey(), view, place.address()),
                                        ranges(each, each.getKey())))
                .toList();
    }

    public static List<CallHierarchyOutgoingCall> outgoing(View view, HierarchyPlace place) {
        return place.find(view.models()).stream()
                .flatMap(
                        referent ->
                                Neighbour.behind(referent, view.models()).entrySet().stream()
                                        .map(
                                                each ->
                                                        new CallHierarchyOutgoingCall(
                                                                item(
                                                                        each.getKey(),
                                                                        view,
                                                                        place.address()),
                                                                ranges(each, referent))))
                .toList();
    }

    /** The protocol wants places in the file of one item; a connector may stand in a third one. */
    private static List<Range> ranges(Map.Entry<Referent, List<Span>> neighbour, Referent caller) {
        Span home = caller.declaration().orElseThrow();
        List<Range> there =
                neighbour.getValue().stream()
                        .filter(span -> span.file() == home.file())
                        .map(Positions::range)
                        .toList();
        return there.isEmpty() ? List.of(Positions.range(home)) : there;
    }
}
