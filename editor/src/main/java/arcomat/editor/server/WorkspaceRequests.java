package arcomat.editor.server;

import arcomat.editor.answer.shape.SymbolSearch;
import arcomat.editor.text.Positions;

import org.eclipse.lsp4j.DidChangeConfigurationParams;
import org.eclipse.lsp4j.DidChangeWatchedFilesParams;
import org.eclipse.lsp4j.DidChangeWorkspaceFoldersParams;
import org.eclipse.lsp4j.ExecuteCommandParams;
import org.eclipse.lsp4j.SymbolInformation;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.WorkspaceSymbol;
import org.eclipse.lsp4j.WorkspaceSymbolParams;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.services.WorkspaceService;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/** What editors say and ask about all files together. */
final class WorkspaceRequests implements WorkspaceService {
    private final Worker worker;

    private final VerdictRequests verdicts;
    private final Consumer<List<String>> libraries;

    /**
     * @param libraries told when settings name other models of others
     */
    WorkspaceRequests(Worker worker, VerdictRequests verdicts, Consumer<List<String>> libraries) {
        this.libraries = libraries;
        this.worker = worker;
        this.verdicts = verdicts;
    }

    @Override
    public CompletableFuture<Object> executeCommand(ExecuteCommandParams params) {
        return verdicts.execute(params);
    }

    @Override
    public void didChangeWatchedFiles(DidChangeWatchedFilesParams params) {
        List<Path> files =
                params.getChanges().stream()
                        .flatMap(each -> Positions.path(each.getUri()).stream())
                        .toList();
        worker.edit(desk -> desk.changedOnDisk(files));
    }

    @Override
    public void didChangeWorkspaceFolders(DidChangeWorkspaceFoldersParams params) {
        for (WorkspaceFolder folder : params.getEvent().getRemoved()) {
            Positions.path(folder.getUri())
                    .ifPresent(path -> worker.edit(desk -> desk.remove(path)));
        }
        for (WorkspaceFolder folder : params.getEvent().getAdded()) {
            Positions.path(folder.getUri()).ifPresent(path -> worker.edit(desk -> desk.add(path)));
        }
    }

    @Override
    public CompletableFuture<
                    Either<List<? extends SymbolInformation>, List<? extends WorkspaceSymbol>>>
            symbol(WorkspaceSymbolParams params) {
        SymbolSearch search = new SymbolSearch(params.getQuery());
        return worker.ask((desk, canceled) -> Either.forRight(search.on(desk)));
    }

    @Override
    public void didChangeConfiguration(DidChangeConfigurationParams params) {
        Object section = LibrarySetting.section(params.getSettings());
        if (section != null) {
            libraries.accept(LibrarySetting.in(section));
        }
    }
}
