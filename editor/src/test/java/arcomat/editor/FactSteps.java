package arcomat.editor;

import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.InlayHint;
import org.eclipse.lsp4j.InlayHintParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.SignatureHelp;
import org.eclipse.lsp4j.SignatureHelpParams;
import org.eclipse.lsp4j.services.TextDocumentService;

import java.util.Optional;
import java.util.stream.Collectors;

/** Steps of a script that are about what an editor shows beside the text. */
final class FactSteps {
    private final EditorClient client;

    FactSteps(EditorClient client) {
        this.client = client;
    }

    /** What there is to see, or nothing where the step is none of these. */
    Optional<String> run(String step, String path, String place) {
        return Optional.ofNullable(
                switch (step) {
                    case "hover" -> hover(path, EditorScript.position(place));
                    case "parameters" -> parameters(path, EditorScript.position(place));
                    case "hints" -> hints(path, EditorScript.range(place));
                    default -> null;
                });
    }

    private TextDocumentService asked() {
        return client.server().getTextDocumentService();
    }

    private String hover(String path, Position at) {
        Hover hover = EditorClient.get(asked().hover(new HoverParams(client.document(path), at)));
        return hover == null
                ? ""
                : EditorScript.written(hover.getRange())
                        + "\n"
                        + hover.getContents().getRight().getValue()
                        + "\n";
    }

    /** Each with the parameter that the cursor is at. */
    private String parameters(String path, Position at) {
        var params = new SignatureHelpParams(client.document(path), at);
        SignatureHelp help = EditorClient.get(asked().signatureHelp(params));
        return help == null
                ? ""
                : help.getSignatures().stream()
                        .map(
                                each ->
                                        "%s at %d\n"
                                                .formatted(
                                                        each.getLabel(), help.getActiveParameter()))
                        .collect(Collectors.joining());
    }

    private String hints(String path, Range range) {
        var params = new InlayHintParams(client.document(path), range);
        return EditorClient.get(asked().inlayHint(params)).stream()
                .map(FactSteps::line)
                .collect(Collectors.joining());
    }

    private static String line(InlayHint hint) {
        Position at = hint.getPosition();
        return "%s %s\n"
                .formatted(EditorScript.written(new Range(at, at)), hint.getLabel().getLeft());
    }
}
