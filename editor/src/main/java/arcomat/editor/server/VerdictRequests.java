package arcomat.editor.server;

import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.editor.verdict.Sheets;
import arcomat.editor.verdict.VerdictLenses;
import arcomat.editor.verdict.Verdicts;
import arcomat.pipeline.verdict.TextVerdict;

import com.google.gson.JsonElement;
import com.google.gson.JsonPrimitive;

import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.CodeLensOptions;
import org.eclipse.lsp4j.ExecuteCommandOptions;
import org.eclipse.lsp4j.ExecuteCommandParams;
import org.eclipse.lsp4j.ServerCapabilities;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;

/** What editors ask about promises, tests and automata. */
final class VerdictRequests {
    private static final List<String> COMMANDS = List.of(VerdictLenses.SHOW, VerdictLenses.RUN);

    private final Worker worker;
    private final Verdicts verdicts;
    private final Consumer<Path> viewer;
    private final Sheets sheets = new Sheets();

    /** Pictures take a while, and nobody who types waits for them. */
    private final ExecutorService drawing =
            Executors.newSingleThreadExecutor(new DeepThreads("pages"));

    /**
     * @param viewer shows a file to whoever sits at the editor
     */
    VerdictRequests(Worker worker, Verdicts verdicts, Consumer<Path> viewer) {
        this.worker = worker;
        this.verdicts = verdicts;
        this.viewer = viewer;
    }

    static void announce(ServerCapabilities can) {
        can.setCodeLensProvider(new CodeLensOptions(false));
        can.setExecuteCommandProvider(new ExecuteCommandOptions(COMMANDS));
    }

    List<CodeLens> lenses(View view) {
        return VerdictLenses.of(view, verdicts);
    }

    /** Does what a lens offers. */
    CompletableFuture<Object> execute(ExecuteCommandParams params) {
        List<String> words = words(params);
        if (!COMMANDS.contains(params.getCommand()) || words.size() != 3) {
            throw failure(
                    ResponseErrorCode.InvalidParams,
                    "there are the commands %s, with address, kind and name"
                            .formatted(String.join(" and ", COMMANDS)));
        }
        return params.getCommand().equals(VerdictLenses.RUN) ? askAgain(words) : show(words);
    }

    /** What comes of it is seen in the text. */
    private CompletableFuture<Object> askAgain(List<String> words) {
        return worker.ask(
                (desk, canceled) -> {
                    verdicts.askAgain(
                            Positions.path(words.get(0))
                                    .flatMap(desk::view)
                                    .orElseThrow(VerdictRequests::outdated));
                    return "";
                });
    }

    /** Shows what a lens stands for, and answers where it is. */
    private CompletableFuture<Object> show(List<String> words) {
        return worker.ask(
                        (desk, canceled) ->
                                Positions.path(words.get(0))
                                        .flatMap(desk::view)
                                        .flatMap(view -> shown(view, words))
                                        .orElseThrow(VerdictRequests::outdated))
                .thenApplyAsync(this::show, drawing);
    }

    private static List<String> words(ExecuteCommandParams params) {
        return params.getArguments() == null
                ? List.of()
                : params.getArguments().stream()
                        .filter(JsonPrimitive.class::isInstance)
                        .map(JsonElement.class::cast)
                        .map(JsonElement::getAsString)
                        .toList();
    }

    private Optional<TextVerdict> shown(View view, List<String> words) {
        return VerdictLenses.shown(view, verdicts, words.get(1), words.get(2));
    }

    private Object show(TextVerdict verdict) {
        try {
            Path sheet = sheets.write(verdict);
            viewer.accept(sheet);
            return sheet.toUri().toString();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static ResponseErrorException outdated() {
        return failure(
                ResponseErrorCode.ContentModified, "the text has changed; it is being asked again");
    }

    private static ResponseErrorException failure(ResponseErrorCode code, String reason) {
        return new ResponseErrorException(new ResponseError(code, reason, null));
    }
}
