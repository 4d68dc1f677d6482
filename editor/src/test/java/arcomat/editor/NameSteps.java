package arcomat.editor;

import org.eclipse.lsp4j.DefinitionParams;
import org.eclipse.lsp4j.DocumentHighlightParams;
import org.eclipse.lsp4j.ImplementationParams;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PrepareRenameParams;
import org.eclipse.lsp4j.ReferenceContext;
import org.eclipse.lsp4j.ReferenceParams;
import org.eclipse.lsp4j.RenameParams;
import org.eclipse.lsp4j.TypeDefinitionParams;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.services.TextDocumentService;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Steps of a script that are about names. */
final class NameSteps {
    private final EditorClient client;

    NameSteps(EditorClient client) {
        this.client = client;
    }

    /** What there is to see, or nothing where the step is none of these. */
    Optional<String> run(String step, String path, String place, String rest) {
        return Optional.ofNullable(
                switch (step) {
                    case "definition", "type-definition", "implementation", "references", "uses" ->
                            written(places(step, path, EditorScript.position(place)));
                    case "highlights" -> highlights(path, EditorScript.position(place));
                    case "rename-what" -> prepared(path, EditorScript.position(place));
                    case "rename" -> renamed(path, EditorScript.position(place), rest);
                    default -> null;
                });
    }

    private TextDocumentService asked() {
        return client.server().getTextDocumentService();
    }

    private List<? extends Location> places(String step, String path, Position at) {
        var file = client.document(path);
        return switch (step) {
            case "definition" ->
                    EditorClient.get(asked().definition(new DefinitionParams(file, at))).getLeft();
            case "type-definition" ->
                    EditorClient.get(asked().typeDefinition(new TypeDefinitionParams(file, at)))
                            .getLeft();
            case "implementation" ->
                    EditorClient.get(asked().implementation(new ImplementationParams(file, at)))
                            .getLeft();
            default -> {
                var context = new ReferenceContext(step.equals("references"));
                yield EditorClient.get(asked().references(new ReferenceParams(file, at, context)));
            }
        };
    }

    private String written(List<? extends Location> places) {
        return places.stream()
                .map(
                        each ->
                                client.path(each.getUri())
                                        + ":"
                                        + EditorScript.written(each.getRange())
                                        + "\n")
                .collect(Collectors.joining());
    }

    private String highlights(String path, Position at) {
        return EditorClient.get(
                        asked().documentHighlight(
                                        new DocumentHighlightParams(client.document(path), at)))
                .stream()
                .map(
                        each ->
                                "%s %s\n"
                                        .formatted(
                                                EditorScript.written(each.getRange()),
                                                each.getKind()))
                .collect(Collectors.joining());
    }

    private String prepared(String path, Position at) {
        return answered(
                asked().prepareRename(new PrepareRenameParams(client.document(path), at)),
                found ->
                        EditorScript.written(found.getSecond().getRange())
                                + " "
                                + found.getSecond().getPlaceholder()
                                + "\n");
    }

    /** Renames, and shows which files have changed. */
    private String renamed(String path, Position at, String name) {
        return answered(
                asked().rename(new RenameParams(client.document(path), at, name)),
                edit -> {
                    try {
                        client.apply(edit);
                    } catch (IOException e) {
                        throw new UncheckedIOException(e);
                    }
                    return client.messages().stream()
                            .map(each -> "warned: " + each + "\n")
                            .collect(Collectors.joining());
                });
    }

    private static <T> String answered(CompletableFuture<T> answer, Function<T, String> shown) {
        try {
            return shown.apply(answer.get(120, TimeUnit.SECONDS));
        } catch (ExecutionException refused) {
            return "refused: "
                    + ((ResponseErrorException) refused.getCause()).getResponseError().getMessage()
                    + "\n";
        } catch (InterruptedException | TimeoutException e) {
            throw new AssertionError(e);
        }
    }
}
