package arcomat.editor.server;

import arcomat.editor.answer.BesideModels;
import arcomat.editor.answer.CanonicalLayout;
import arcomat.editor.answer.Fixes;
import arcomat.editor.answer.completion.Completion;
import arcomat.editor.desk.Desk;
import arcomat.editor.text.Positions;

import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.CodeLensParams;
import org.eclipse.lsp4j.Command;
import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionList;
import org.eclipse.lsp4j.CompletionParams;
import org.eclipse.lsp4j.DefinitionParams;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.DidCloseTextDocumentParams;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.DidSaveTextDocumentParams;
import org.eclipse.lsp4j.DocumentFormattingParams;
import org.eclipse.lsp4j.DocumentRangeFormattingParams;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.LocationLink;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** What editors say and ask about one file. */
final class DocumentRequests extends NameRequests {
    private final Worker worker;
    private final VerdictRequests verdicts;
    private final BiConsumer<Desk, Path> opened;

    /**
     * @param opened told after a file was opened
     */
    DocumentRequests(
            Worker worker,
            BooleanSupplier movesFiles,
            Consumer<String> warnings,
            VerdictRequests verdicts,
            BiConsumer<Desk, Path> opened) {
        super(worker, movesFiles, warnings);
        this.worker = worker;
        this.verdicts = verdicts;
        this.opened = opened;
    }

    @Override
    public void didOpen(DidOpenTextDocumentParams params) {
        var document = params.getTextDocument();
        Positions.path(document.getUri())
                .ifPresent(
                        file ->
                                worker.edit(
                                        desk -> {
                                            desk.open(file, document.getText());
                                            opened.accept(desk, file);
                                        }));
    }

    @Override
    public void didChange(DidChangeTextDocumentParams params) {
        Positions.path(params.getTextDocument().getUri())
                .ifPresent(
                        file -> worker.edit(desk -> desk.change(file, params.getContentChanges())));
    }

    @Override
    public void didClose(DidCloseTextDocumentParams params) {
        Positions.path(params.getTextDocument().getUri())
                .ifPresent(file -> worker.edit(desk -> desk.close(file)));
    }

    /** What is on the screen is known already. */
    @Override
    public void didSave(DidSaveTextDocumentParams params) {}

    @Override
    public CompletableFuture<List<Either<Command, CodeAction>>> codeAction(
            CodeActionParams params) {
        Optional<Path> file = Positions.path(params.getTextDocument().getUri());
        return worker.askChecked(
                file,
                (desk, canceled) ->
                        file
                                .flatMap(desk::view)
                                .filter(view -> view.reader().isEmpty())
                                .map(view -> Fixes.at(view, params.getRange(), params.getContext()))
                                .orElse(List.of())
                                .stream()
                                .map(Either::<Command, CodeAction>forRight)
                                .toList());
    }

    @Override
    public CompletableFuture<List<? extends CodeLens>> codeLens(CodeLensParams params) {
        return ask(params.getTextDocument(), verdicts::lenses).thenApply(lenses -> lenses);
    }

    @Override
    public CompletableFuture<Either<List<CompletionItem>, CompletionList>> completion(
            CompletionParams params) {
        Position position = params.getPosition();
        return worker.ask(
                        (desk, canceled) ->
                                BesideModels.on(desk, params.getTextDocument())
                                        .map(text -> text.completion(position))
                                        .orElseGet(() -> completion(desk, params)))
                .thenApply(Either::forLeft);
    }

    private static List<CompletionItem> completion(Desk desk, CompletionParams params) {
        return Positions.path(params.getTextDocument().getUri())
                .flatMap(desk::view)
                .filter(view -> view.reader().isEmpty())
                .map(view -> Completion.at(view, view.offset(params.getPosition())))
                .orElse(List.of());
    }

    @Override
    public CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
            definition(DefinitionParams params) {
        return worker.ask(
                        (desk, canceled) ->
                                BesideModels.on(desk, params.getTextDocument())
                                        .map(text -> text.definition(params.getPosition())))
                .thenCompose(
                        found ->
                                found.isPresent()
                                        ? CompletableFuture.completedFuture(
                                                Either.forLeft(found.get()))
                                        : super.definition(params));
    }

    @Override
    public CompletableFuture<List<? extends TextEdit>> formatting(DocumentFormattingParams params) {
        return askOwn(params.getTextDocument(), view -> CanonicalLayout.of(view))
                .thenApply(edits -> edits);
    }

    @Override
    public CompletableFuture<List<? extends TextEdit>> rangeFormatting(
            DocumentRangeFormattingParams params) {
        return askOwn(params.getTextDocument(), view -> CanonicalLayout.in(view, params.getRange()))
                .thenApply(edits -> edits);
    }
}
