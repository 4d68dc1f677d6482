package arcomat.editor.server;

import arcomat.editor.answer.flow.ConnectorHierarchy;
import arcomat.editor.answer.flow.HierarchyPlace;
import arcomat.editor.answer.shape.DocumentOutline;
import arcomat.editor.answer.shape.Folds;
import arcomat.editor.answer.shape.NameColours;
import arcomat.editor.answer.shape.Selections;
import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;

import org.eclipse.lsp4j.CallHierarchyIncomingCall;
import org.eclipse.lsp4j.CallHierarchyIncomingCallsParams;
import org.eclipse.lsp4j.CallHierarchyItem;
import org.eclipse.lsp4j.CallHierarchyOutgoingCall;
import org.eclipse.lsp4j.CallHierarchyOutgoingCallsParams;
import org.eclipse.lsp4j.CallHierarchyPrepareParams;
import org.eclipse.lsp4j.DocumentSymbol;
import org.eclipse.lsp4j.DocumentSymbolParams;
import org.eclipse.lsp4j.FoldingRange;
import org.eclipse.lsp4j.FoldingRangeRequestParams;
import org.eclipse.lsp4j.SelectionRange;
import org.eclipse.lsp4j.SelectionRangeParams;
import org.eclipse.lsp4j.SemanticTokens;
import org.eclipse.lsp4j.SemanticTokensParams;
import org.eclipse.lsp4j.SemanticTokensWithRegistrationOptions;
import org.eclipse.lsp4j.ServerCapabilities;
import org.eclipse.lsp4j.SymbolInformation;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.services.TextDocumentService;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiFunction;
import java.util.function.Function;

/** What editors ask about the shape of one file, and about what is connected with what. */
abstract class ShapeRequests implements TextDocumentService {
    private final Worker worker;

    ShapeRequests(Worker worker) {
        this.worker = worker;
    }

    static void announce(ServerCapabilities can) {
        can.setDocumentSymbolProvider(true);
        can.setWorkspaceSymbolProvider(true);
        can.setFoldingRangeProvider(true);
        can.setSelectionRangeProvider(true);
        can.setCallHierarchyProvider(true);
        can.setSemanticTokensProvider(
                new SemanticTokensWithRegistrationOptions(NameColours.LEGEND, true, false));
    }

    /** Asks about a model as it is on the screen; the answer is empty where it is none. */
    final <T> CompletableFuture<List<T>> ask(
            TextDocumentIdentifier document, Function<View, List<T>> question) {
        return worker.ask(
                (desk, canceled) ->
                        Positions.path(document.getUri())
                                .flatMap(desk::view)
                                .map(question)
                                .orElse(List.of()));
    }

    /** Asks about what is written in the tool's language: nobody else knows how a guest's is. */
    final <T> CompletableFuture<List<T>> askOwn(
            TextDocumentIdentifier document, Function<View, List<T>> question) {
        return ask(document, view -> view.reader().isPresent() ? List.of() : question.apply(view));
    }

    /** The same where there is one answer or none, which the protocol calls null. */
    final <T> CompletableFuture<T> askOne(
            TextDocumentIdentifier document, Function<View, Optional<T>> question) {
        return worker.ask(
                        (desk, canceled) ->
                                Positions.path(document.getUri())
                                        .flatMap(desk::view)
                                        .flatMap(question))
                .thenApply(found -> found.orElse(null));
    }

    @Override
    public CompletableFuture<List<Either<SymbolInformation, DocumentSymbol>>> documentSymbol(
            DocumentSymbolParams params) {
        return ask(
                params.getTextDocument(),
                view ->
                        DocumentOutline.of(view).stream()
                                .map(Either::<SymbolInformation, DocumentSymbol>forRight)
                                .toList());
    }

    @Override
    public CompletableFuture<List<FoldingRange>> foldingRange(FoldingRangeRequestParams params) {
        return askOwn(params.getTextDocument(), Folds::of);
    }

    @Override
    public CompletableFuture<List<SelectionRange>> selectionRange(SelectionRangeParams params) {
        return askOwn(params.getTextDocument(), view -> Selections.at(view, params.getPositions()));
    }

    @Override
    public CompletableFuture<SemanticTokens> semanticTokensFull(SemanticTokensParams params) {
        return askOne(params.getTextDocument(), view -> Optional.of(NameColours.of(view)));
    }

    @Override
    public CompletableFuture<List<CallHierarchyItem>> prepareCallHierarchy(
            CallHierarchyPrepareParams params) {
        return ask(
                params.getTextDocument(),
                view -> ConnectorHierarchy.prepare(view, params.getPosition()));
    }

    @Override
    public CompletableFuture<List<CallHierarchyIncomingCall>> callHierarchyIncomingCalls(
            CallHierarchyIncomingCallsParams params) {
        return neighbours(params.getItem(), ConnectorHierarchy::incoming);
    }

    @Override
    public CompletableFuture<List<CallHierarchyOutgoingCall>> callHierarchyOutgoingCalls(
            CallHierarchyOutgoingCallsParams params) {
        return neighbours(params.getItem(), ConnectorHierarchy::outgoing);
    }

    private <T> CompletableFuture<List<T>> neighbours(
            CallHierarchyItem item, BiFunction<View, HierarchyPlace, List<T>> question) {
        return HierarchyPlace.read(item.getData())
                .map(
                        place ->
                                ask(
                                        new TextDocumentIdentifier(place.address()),
                                        view -> question.apply(view, place)))
                .orElseGet(() -> CompletableFuture.completedFuture(List.of()));
    }
}
