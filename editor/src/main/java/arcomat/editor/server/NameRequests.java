package arcomat.editor.server;

import arcomat.editor.answer.GoTo;
import arcomat.editor.answer.NamedPlaces;
import arcomat.editor.answer.Renames;
import arcomat.editor.desk.Desk;
import arcomat.editor.desk.View;
import arcomat.editor.name.RenameRefused;
import arcomat.editor.text.Positions;

import org.eclipse.lsp4j.DefinitionParams;
import org.eclipse.lsp4j.DocumentHighlight;
import org.eclipse.lsp4j.DocumentHighlightParams;
import org.eclipse.lsp4j.ImplementationParams;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.LocationLink;
import org.eclipse.lsp4j.PrepareRenameDefaultBehavior;
import org.eclipse.lsp4j.PrepareRenameParams;
import org.eclipse.lsp4j.PrepareRenameResult;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.ReferenceParams;
import org.eclipse.lsp4j.RenameOptions;
import org.eclipse.lsp4j.RenameParams;
import org.eclipse.lsp4j.ServerCapabilities;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TypeDefinitionParams;
import org.eclipse.lsp4j.WorkspaceEdit;
import org.eclipse.lsp4j.jsonrpc.CancelChecker;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.jsonrpc.messages.Either3;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;

/** What editors ask about names in one file. */
abstract class NameRequests extends FactRequests {
    private final Worker worker;
    private final BooleanSupplier movesFiles;
    private final Consumer<String> warnings;

    /**
     * @param movesFiles whether the editor can rename files, once it has said so
     * @param warnings shown to whoever sits in front of the editor
     */
    NameRequests(Worker worker, BooleanSupplier movesFiles, Consumer<String> warnings) {
        super(worker);
        this.worker = worker;
        this.movesFiles = movesFiles;
        this.warnings = warnings;
    }

    static void announce(ServerCapabilities can) {
        FactRequests.announce(can);
        can.setDefinitionProvider(true);
        can.setTypeDefinitionProvider(true);
        can.setImplementationProvider(true);
        can.setReferencesProvider(true);
        can.setDocumentHighlightProvider(true);
        can.setRenameProvider(new RenameOptions(true));
    }

    private CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
            locations(TextDocumentIdentifier document, Function<View, List<Location>> question) {
        return ask(document, question).thenApply(Either::forLeft);
    }

    @Override
    public CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
            definition(DefinitionParams params) {
        return locations(
                params.getTextDocument(), view -> GoTo.definition(view, params.getPosition()));
    }

    @Override
    public CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
            typeDefinition(TypeDefinitionParams params) {
        return locations(
                params.getTextDocument(), view -> GoTo.typeDefinition(view, params.getPosition()));
    }

    @Override
    public CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
            implementation(ImplementationParams params) {
        return locations(
                params.getTextDocument(), view -> GoTo.implementation(view, params.getPosition()));
    }

    @Override
    public CompletableFuture<List<? extends Location>> references(ReferenceParams params) {
        boolean declaration = params.getContext().isIncludeDeclaration();
        return ask(
                        params.getTextDocument(),
                        view -> NamedPlaces.references(view, params.getPosition(), declaration))
                .thenApply(places -> places);
    }

    @Override
    public CompletableFuture<List<? extends DocumentHighlight>> documentHighlight(
            DocumentHighlightParams params) {
        return ask(params.getTextDocument(), view -> NamedPlaces.inFile(view, params.getPosition()))
                .thenApply(places -> places);
    }

    /** An answer that may be refused with a reason. */
    private interface Refusable<T> {
        T of(View view) throws RenameRefused;
    }

    private static <T> T answer(Desk desk, TextDocumentIdentifier document, Refusable<T> question) {
        Optional<View> view = Positions.path(document.getUri()).flatMap(desk::view);
        if (view.isEmpty()) {
            throw failure("this is no model that can be read");
        }
        try {
            return question.of(view.get());
        } catch (RenameRefused refused) {
            throw failure(refused.reason());
        }
    }

    private static ResponseErrorException failure(String reason) {
        return new ResponseErrorException(
                new ResponseError(ResponseErrorCode.RequestFailed, reason, null));
    }

    @Override
    public CompletableFuture<Either3<Range, PrepareRenameResult, PrepareRenameDefaultBehavior>>
            prepareRename(PrepareRenameParams params) {
        return worker.ask(
                (desk, canceled) ->
                        Either3.forSecond(
                                answer(
                                        desk,
                                        params.getTextDocument(),
                                        view -> Renames.prepare(view, params.getPosition()))));
    }

    @Override
    public CompletableFuture<WorkspaceEdit> rename(RenameParams params) {
        return worker.askChecked(
                Optional.empty(),
                (desk, canceled) -> {
                    Renames.Answer answer =
                            answer(
                                    desk,
                                    params.getTextDocument(),
                                    view -> renamed(params, view, desk, canceled));
                    answer.warning().ifPresent(warnings);
                    return answer.edit();
                });
    }

    private Renames.Answer renamed(
            RenameParams params, View view, Desk desk, CancelChecker canceled)
            throws RenameRefused {
        return Renames.edit(
                view,
                params.getPosition(),
                params.getNewName(),
                movesFiles.getAsBoolean(),
                () -> desk.around(view.models()),
                canceled::checkCanceled);
    }
}
