package arcomat.editor.server;

import arcomat.editor.answer.Diagnostics;
import arcomat.editor.answer.Fixes;
import arcomat.editor.desk.Desk;
import arcomat.editor.text.Positions;
import arcomat.editor.verdict.Verdicts;
import arcomat.guest.host.Guests;
import arcomat.pipeline.recheck.OpenModels;

import org.eclipse.lsp4j.CodeActionKind;
import org.eclipse.lsp4j.CodeActionOptions;
import org.eclipse.lsp4j.CompletionOptions;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DidChangeWatchedFilesRegistrationOptions;
import org.eclipse.lsp4j.FileSystemWatcher;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializeResult;
import org.eclipse.lsp4j.InitializedParams;
import org.eclipse.lsp4j.MessageParams;
import org.eclipse.lsp4j.MessageType;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.Registration;
import org.eclipse.lsp4j.RegistrationParams;
import org.eclipse.lsp4j.ServerCapabilities;
import org.eclipse.lsp4j.ServerInfo;
import org.eclipse.lsp4j.SetTraceParams;
import org.eclipse.lsp4j.ShowDocumentParams;
import org.eclipse.lsp4j.TextDocumentSyncKind;
import org.eclipse.lsp4j.WorkDoneProgressCancelParams;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.WorkspaceFoldersOptions;
import org.eclipse.lsp4j.WorkspaceServerCapabilities;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.LanguageServer;
import org.eclipse.lsp4j.services.TextDocumentService;
import org.eclipse.lsp4j.services.WorkspaceService;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The server as the protocol sees it: what it can do, and how it begins and ends. */
public final class EditorServer implements LanguageServer {
    /** All kinds of files that it wants to hear of. */
    private static final String FILES = "**/*.{arc,cd,ioautomaton,maa,mt,world,script,campaign}";

    /** Who types without a pause wants no verdicts yet. */
    private static final Duration QUIET = Duration.ofMillis(200);

    private final String version;
    private final List<Path> libraries;
    private final Worker worker;
    private final ScheduledThreadPoolExecutor asking =
            new ScheduledThreadPoolExecutor(1, new DeepThreads("verdicts"));
    private final Verdicts verdicts;
    private final VerdictRequests verdictRequests;
    private final CompletableFuture<Integer> exit = new CompletableFuture<>();
    private final Map<String, List<Diagnostic>> published = new HashMap<>();

    @SuppressWarnings("NullAway.Init") // connected before the first message is read
    private LanguageClient client;

    private volatile Abilities abilities = Abilities.NONE;

    /** Where folders in settings start from. */
    private volatile Path home = Path.of("").toAbsolutePath();

    /**
     * Whether the editor is ready for what it has not asked for; known to the thread that works on
     * the desk.
     */
    private boolean greeted;

    private boolean shutDown;
    private final Guests guests;

    /**
     * @param version of the tool
     * @param guests who bring laws and behaviour languages
     * @param libraries model roots of others, absolute; settings may name more
     */
    public EditorServer(String version, Guests guests, List<Path> libraries) {
        this.version = version;
        this.libraries = List.copyOf(libraries);
        this.guests = guests;
        this.worker = new Worker(guests, this::publish);
        this.verdicts = new Verdicts(asking, QUIET, this::refreshLenses);
        this.verdictRequests = new VerdictRequests(worker, verdicts, this::show);
    }

    /** Says who is asking. */
    public void connect(LanguageClient asking) {
        client = asking;
    }

    /** The exit status, once the editor has said that it needs the server no more. */
    public CompletableFuture<Integer> exitStatus() {
        return exit;
    }

    @Override
    public CompletableFuture<InitializeResult> initialize(InitializeParams params) {
        abilities = Abilities.of(params.getCapabilities());
        List<Path> folders =
                folders(params).stream()
                        .flatMap(address -> Positions.path(address).stream())
                        .toList();
        folders.stream().findFirst().ifPresent(first -> home = first);
        referTo(LibrarySetting.in(params.getInitializationOptions()));
        folders.forEach(path -> worker.edit(desk -> desk.add(path)));
        return CompletableFuture.completedFuture(
                new InitializeResult(capabilities(), new ServerInfo("Arcomat", version)));
    }

    /**
     * Models may refer to those of others.
     *
     * @param written model roots, as settings name them, besides those that have been named at the
     *     start
     */
    private void referTo(List<String> written) {
        List<Path> all = new ArrayList<>(libraries);
        written.forEach(each -> all.add(home.resolve(each).normalize()));
        worker.edit(
                desk ->
                        desk.referTo(all)
                                .forEach(
                                        each ->
                                                warn(
                                                        "%s; look at the setting arcomat.libraries"
                                                                .formatted(each.message()))));
    }

    /** Older editors know one folder only. */
    @SuppressWarnings("deprecation")
    private static List<String> folders(InitializeParams params) {
        if (params.getWorkspaceFolders() != null) {
            return params.getWorkspaceFolders().stream().map(WorkspaceFolder::getUri).toList();
        }
        return params.getRootUri() == null ? List.of() : List.of(params.getRootUri());
    }

    private static ServerCapabilities capabilities() {
        ServerCapabilities can = new ServerCapabilities();
        can.setTextDocumentSync(TextDocumentSyncKind.Incremental);
        can.setCodeActionProvider(
                new CodeActionOptions(List.of(CodeActionKind.QuickFix, Fixes.ALL)));
        can.setCompletionProvider(new CompletionOptions(false, List.of(".", " ")));
        can.setDocumentFormattingProvider(true);
        can.setDocumentRangeFormattingProvider(true);
        NameRequests.announce(can);
        VerdictRequests.announce(can);
        WorkspaceFoldersOptions folders = new WorkspaceFoldersOptions();
        folders.setSupported(true);
        folders.setChangeNotifications(true);
        can.setWorkspace(new WorkspaceServerCapabilities(folders));
        return can;
    }

    @Override
    public void initialized(InitializedParams params) {
        if (abilities.watches()) {
            var options =
                    new DidChangeWatchedFilesRegistrationOptions(
                            Stream.concat(
                                            Stream.of(FILES),
                                            guests.endings().stream().map(each -> "**/*" + each))
                                    .map(each -> new FileSystemWatcher(Either.forLeft(each)))
                                    .toList());
            var registration =
                    new Registration("files", "workspace/didChangeWatchedFiles", options);
            // An editor that says no does without.
            var unused = client.registerCapability(new RegistrationParams(List.of(registration)));
        }
        worker.edit(
                desk -> {
                    greeted = true;
                    publish(desk);
                });
    }

    /** Who opens a file does not wait until all others have been read. */
    private void publishFirst(Desk desk, Path file) {
        desk.firstLook(file)
                .ifPresent(
                        look ->
                                publish(
                                        file.toUri().toString(),
                                        Diagnostics.of(
                                                look.findings(),
                                                each -> address(desk, look.models(), each))));
    }

    /**
     * Sends what is new to the editor, and that nothing is found where something was. Of files that
     * are to be checked again it still shows what was found last. The protocol allows no findings
     * before the editor is ready, and Kate loses such; a small workspace is checked before that.
     */
    private void publish(Desk desk) {
        if (!greeted) {
            return;
        }
        Set<String> gone = new HashSet<>(published.keySet());
        if (desk.models().stream().anyMatch(models -> !models.due().isEmpty())) {
            gone.retainAll(addresses(desk.onScreen()));
        }
        for (OpenModels models : desk.models()) {
            for (String path : models.checkedPaths()) {
                // The file system is asked for each address.
                boolean found = !models.findings(path).isEmpty();
                if (found && !models.due().contains(path) && desk.isShown(models, path)) {
                    String address = address(desk, models, path);
                    gone.remove(address);
                    publish(
                            address,
                            Diagnostics.of(models, path, each -> address(desk, models, each)));
                }
            }
        }
        for (Path file : desk.onScreen()) {
            desk.beside(file)
                    .ifPresent(
                            text -> {
                                String address = file.toUri().toString();
                                gone.remove(address);
                                publish(address, Diagnostics.of(text.findings(), any -> address));
                            });
        }
        gone.forEach(address -> publish(address, List.of()));
        verdicts.changed(desk);
    }

    private static Set<String> addresses(Set<Path> files) {
        return files.stream().map(file -> file.toUri().toString()).collect(Collectors.toSet());
    }

    private void refreshLenses() {
        if (abilities.refreshesLenses()) {
            var unused = client.refreshCodeLenses();
        }
    }

    /** Pages are for browsers; who cannot open anything tells where it is. */
    private void show(Path sheet) {
        if (abilities.showsDocuments()) {
            var document = new ShowDocumentParams(sheet.toUri().toString());
            document.setExternal(sheet.toString().endsWith(".html"));
            document.setTakeFocus(true);
            var unused = client.showDocument(document);
        } else {
            client.showMessage(new MessageParams(MessageType.Info, "to be looked at: " + sheet));
        }
    }

    private static String address(Desk desk, OpenModels models, String path) {
        return desk.place(models, path).toUri().toString();
    }

    private void publish(String address, List<Diagnostic> findings) {
        List<Diagnostic> last = published.getOrDefault(address, List.of());
        if (!findings.equals(last)) {
            published.put(address, findings);
            client.publishDiagnostics(new PublishDiagnosticsParams(address, findings));
        }
    }

    private void warn(String message) {
        client.showMessage(new MessageParams(MessageType.Warning, message));
    }

    @Override
    public CompletableFuture<Object> shutdown() {
        shutDown = true;
        worker.end();
        asking.shutdownNow();
        return CompletableFuture.completedFuture(null);
    }

    /** Status 0 only where the editor has said before that it would go. */
    @Override
    public void exit() {
        exit.complete(shutDown ? 0 : 1);
    }

    /** Nothing is traced. */
    @Override
    public void setTrace(SetTraceParams params) {}

    /** No progress is told. */
    @Override
    public void cancelProgress(WorkDoneProgressCancelParams params) {}

    @Override
    public TextDocumentService getTextDocumentService() {
        return new DocumentRequests(
                worker,
                () -> abilities.movesFiles(),
                this::warn,
                verdictRequests,
                this::publishFirst);
    }

    @Override
    public WorkspaceService getWorkspaceService() {
        return new WorkspaceRequests(worker, verdictRequests, this::referTo);
    }
}
