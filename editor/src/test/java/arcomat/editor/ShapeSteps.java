package arcomat.editor;

import org.eclipse.lsp4j.CallHierarchyIncomingCallsParams;
import org.eclipse.lsp4j.CallHierarchyItem;
import org.eclipse.lsp4j.CallHierarchyOutgoingCallsParams;
import org.eclipse.lsp4j.CallHierarchyPrepareParams;
import org.eclipse.lsp4j.DocumentSymbol;
import org.eclipse.lsp4j.DocumentSymbolParams;
import org.eclipse.lsp4j.FoldingRangeRequestParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.SelectionRange;
import org.eclipse.lsp4j.SelectionRangeParams;
import org.eclipse.lsp4j.SemanticTokensLegend;
import org.eclipse.lsp4j.SemanticTokensParams;
import org.eclipse.lsp4j.WorkspaceSymbolParams;
import org.eclipse.lsp4j.services.TextDocumentService;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Steps of a script that are about the shape of a text, and about what is connected with what. */
final class ShapeSteps {
    private final EditorClient client;

    ShapeSteps(EditorClient client) {
        this.client = client;
    }

    /** What there is to see, or nothing where the step is none of these. */
    Optional<String> run(String step, String path, String place) {
        return Optional.ofNullable(
                switch (step) {
                    case "outline" -> outline(path);
                    case "symbols" -> symbols(path);
                    case "folds" -> folds(path);
                    case "selections" -> selections(path, EditorScript.position(place));
                    case "colours" -> colours(path);
                    case "before" -> before(path, EditorScript.position(place));
                    case "behind" -> behind(path, EditorScript.position(place));
                    default -> null;
                });
    }

    private TextDocumentService asked() {
        return client.server().getTextDocumentService();
    }

    private String outline(String path) {
        var params = new DocumentSymbolParams(client.document(path));
        return EditorClient.get(asked().documentSymbol(params)).stream()
                .map(each -> lines(each.getRight(), ""))
                .collect(Collectors.joining());
    }

    private static String lines(DocumentSymbol symbol, String indent) {
        return "%s%s %s (%s) %s in %s\n"
                        .formatted(
                                indent,
                                symbol.getKind(),
                                symbol.getName(),
                                symbol.getDetail(),
                                EditorScript.written(symbol.getSelectionRange()),
                                EditorScript.written(symbol.getRange()))
                + symbol.getChildren().stream()
                        .map(each -> lines(each, indent + "  "))
                        .collect(Collectors.joining());
    }

    private String symbols(String query) {
        var found = client.server().getWorkspaceService().symbol(new WorkspaceSymbolParams(query));
        return EditorClient.get(found).getRight().stream()
                .map(
                        each ->
                                "%s %s in %s at %s:%s\n"
                                        .formatted(
                                                each.getKind(),
                                                each.getName(),
                                                each.getContainerName(),
                                                client.path(each.getLocation().getLeft().getUri()),
                                                EditorScript.written(
                                                        each.getLocation().getLeft().getRange())))
                .collect(Collectors.joining());
    }

    private String folds(String path) {
        var params = new FoldingRangeRequestParams(client.document(path));
        return EditorClient.get(asked().foldingRange(params)).stream()
                .map(
                        each ->
                                "%d-%d%s\n"
                                        .formatted(
                                                each.getStartLine() + 1,
                                                each.getEndLine() + 1,
                                                each.getKind() == null ? "" : " " + each.getKind()))
                .collect(Collectors.joining());
    }

    private String selections(String path, Position at) {
        var params = new SelectionRangeParams(client.document(path), List.of(at));
        StringBuilder text = new StringBuilder();
        SelectionRange range = EditorClient.get(asked().selectionRange(params)).get(0);
        while (range != null) {
            text.append(EditorScript.written(range.getRange())).append('\n');
            range = range.getParent();
        }
        return text.toString();
    }

    /** Each coloured word with what it is. */
    private String colours(String path) {
        var params = new SemanticTokensParams(client.document(path));
        List<Integer> data = EditorClient.get(asked().semanticTokensFull(params)).getData();
        SemanticTokensLegend legend = client.capabilities().getSemanticTokensProvider().getLegend();
        StringBuilder text = new StringBuilder();
        Position at = new Position(0, 0);
        for (int i = 0; i < data.size(); i += 5) {
            int lines = data.get(i);
            int column = data.get(i + 1) + (lines == 0 ? at.getCharacter() : 0);
            at = new Position(at.getLine() + lines, column);
            Position end = new Position(at.getLine(), column + data.get(i + 2));
            text.append(EditorScript.written(new Range(at, end)))
                    .append(' ')
                    .append(legend.getTokenTypes().get(data.get(i + 3)))
                    .append(modifiers(legend, data.get(i + 4)))
                    .append('\n');
        }
        return text.toString();
    }

    private static String modifiers(SemanticTokensLegend legend, int bits) {
        List<String> all = legend.getTokenModifiers();
        return IntStream.range(0, all.size())
                .filter(i -> (bits >> i & 1) == 1)
                .mapToObj(i -> " " + all.get(i))
                .collect(Collectors.joining());
    }

    private List<CallHierarchyItem> items(String path, Position at) {
        var params = new CallHierarchyPrepareParams(client.document(path), at);
        return EditorClient.get(asked().prepareCallHierarchy(params));
    }

    private String before(String path, Position at) {
        return items(path, at).stream()
                .map(CallHierarchyIncomingCallsParams::new)
                .flatMap(
                        each -> EditorClient.get(asked().callHierarchyIncomingCalls(each)).stream())
                .map(each -> line(each.getFrom(), each.getFromRanges()))
                .collect(Collectors.joining());
    }

    private String behind(String path, Position at) {
        return items(path, at).stream()
                .map(CallHierarchyOutgoingCallsParams::new)
                .flatMap(
                        each -> EditorClient.get(asked().callHierarchyOutgoingCalls(each)).stream())
                .map(each -> line(each.getTo(), each.getFromRanges()))
                .collect(Collectors.joining());
    }

    private String line(CallHierarchyItem item, List<Range> places) {
        return "%s (%s) %s:%s by %s\n"
                .formatted(
                        item.getName(),
                        item.getDetail(),
                        client.path(item.getUri()),
                        EditorScript.written(item.getSelectionRange()),
                        places.stream()
                                .map(EditorScript::written)
                                .collect(Collectors.joining(", ")));
    }
}
