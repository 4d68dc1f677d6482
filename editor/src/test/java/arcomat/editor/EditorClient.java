package arcomat.editor;

import arcomat.editor.server.EditorConnection;
import arcomat.editor.server.EditorServer;
import arcomat.guest.host.Guests;
import arcomat.pipeline.check.LibraryFolder;
import arcomat.source.SourceFile;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;

import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.Command;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DidChangeConfigurationParams;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.DidCloseTextDocumentParams;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializedParams;
import org.eclipse.lsp4j.MessageActionItem;
import org.eclipse.lsp4j.MessageParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.RenameFile;
import org.eclipse.lsp4j.ResourceOperation;
import org.eclipse.lsp4j.ResourceOperationKind;
import org.eclipse.lsp4j.ServerCapabilities;
import org.eclipse.lsp4j.ShowDocumentCapabilities;
import org.eclipse.lsp4j.ShowDocumentParams;
import org.eclipse.lsp4j.ShowDocumentResult;
import org.eclipse.lsp4j.ShowMessageRequestParams;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;
import org.eclipse.lsp4j.TextDocumentEdit;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextDocumentItem;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.VersionedTextDocumentIdentifier;
import org.eclipse.lsp4j.WindowClientCapabilities;
import org.eclipse.lsp4j.WorkspaceClientCapabilities;
import org.eclipse.lsp4j.WorkspaceEdit;
import org.eclipse.lsp4j.WorkspaceEditCapabilities;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.launch.LSPLauncher;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.LanguageServer;

import java.io.IOException;
import java.net.URI;
import java.nio.channels.Channels;
import java.nio.channels.Pipe;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;

/**
 * An editor without a screen: it keeps the texts that are open, does the edits that it is sent, and
 * talks to the server through the protocol, as bytes in a pipe.
 */
final class EditorClient implements LanguageClient, AutoCloseable {
    private static final long PATIENCE_SECONDS = 120;

    private final Path folder;
    private final LanguageServer server;
    private final ServerCapabilities announced;
    private final Map<String, SourceFile> open = new TreeMap<>();
    private final Map<String, Integer> versions = new TreeMap<>();
    private final List<String> messages = new CopyOnWriteArrayList<>();
    private final Map<String, List<Diagnostic>> problems = new ConcurrentHashMap<>();
    private final List<String> shown = new CopyOnWriteArrayList<>();

    /**
     * @param folder the workspace
     */
    EditorClient(Path folder) throws IOException {
        this(folder, Guests.NONE);
    }

    /**
     * @param guests who bring languages
     */
    EditorClient(Path folder, Guests guests) throws IOException {
        this.folder = folder;
        // A PipedInputStream ends when the thread that wrote last does.
        Pipe toServer = Pipe.open();
        Pipe toClient = Pipe.open();
        EditorServer served = new EditorServer("0", guests, List.of());
        var serving =
                EditorConnection.of(
                        served,
                        Channels.newInputStream(toServer.source()),
                        Channels.newOutputStream(toClient.sink()));
        served.connect(serving.getRemoteProxy());
        serving.startListening();
        var asking =
                LSPLauncher.createClientLauncher(
                        this,
                        Channels.newInputStream(toClient.source()),
                        Channels.newOutputStream(toServer.sink()));
        this.server = asking.getRemoteProxy();
        asking.startListening();
        InitializeParams params = new InitializeParams();
        params.setCapabilities(own());
        params.setWorkspaceFolders(List.of(new WorkspaceFolder(address("."), "test")));
        this.announced = get(server.initialize(params)).getCapabilities();
        server.initialized(new InitializedParams());
    }

    private static ClientCapabilities own() {
        var edits = new WorkspaceEditCapabilities();
        edits.setDocumentChanges(true);
        edits.setResourceOperations(List.of(ResourceOperationKind.Rename));
        var workspace = new WorkspaceClientCapabilities();
        workspace.setWorkspaceEdit(edits);
        ClientCapabilities capabilities = new ClientCapabilities();
        capabilities.setWorkspace(workspace);
        var window = new WindowClientCapabilities();
        window.setShowDocument(new ShowDocumentCapabilities(true));
        capabilities.setWindow(window);
        return capabilities;
    }

    /** What the server says that it can do. */
    ServerCapabilities capabilities() {
        return announced;
    }

    LanguageServer server() {
        return server;
    }

    String address(String path) {
        return folder.resolve(path).normalize().toUri().toString();
    }

    /**
     * The path below the workspace, with forward slashes; of a model of the library, its name
     * behind {@code library:}. Other addresses outside are left as they are.
     */
    String path(String address) {
        Path file = Path.of(URI.create(address));
        if (LibraryFolder.holds(file)) {
            return "library:" + file.getFileName();
        }
        String start = folder.toUri().toString();
        return address.startsWith(start) ? address.substring(start.length()) : address;
    }

    TextDocumentIdentifier document(String path) {
        return new TextDocumentIdentifier(address(path));
    }

    static <T> T get(CompletableFuture<T> answer) {
        try {
            return answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    void open(String path) throws IOException {
        String text = Files.readString(folder.resolve(path));
        open.put(path, new SourceFile(path, text));
        versions.put(path, 1);
        var document = new TextDocumentItem(address(path), "arcomat", 1, text);
        server.getTextDocumentService().didOpen(new DidOpenTextDocumentParams(document));
    }

    void close(String path) {
        open.remove(path);
        server.getTextDocumentService().didClose(new DidCloseTextDocumentParams(document(path)));
    }

    boolean isOpen(String path) {
        return open.containsKey(path);
    }

    SourceFile text(String path) {
        SourceFile text = open.get(path);
        if (text == null) {
            throw new AssertionError(path + " is not open");
        }
        return text;
    }

    /** Replaces a range, as somebody does who types. */
    void replace(String path, Range range, String text) {
        SourceFile before = text(path);
        int start = offset(before, range.getStart());
        int end = offset(before, range.getEnd());
        String after = before.text().substring(0, start) + text + before.text().substring(end);
        open.put(path, new SourceFile(path, after));
        int version = versions.merge(path, 1, Integer::sum);
        server.getTextDocumentService()
                .didChange(
                        new DidChangeTextDocumentParams(
                                new VersionedTextDocumentIdentifier(address(path), version),
                                List.of(new TextDocumentContentChangeEvent(range, text))));
    }

    private static int offset(SourceFile file, Position position) {
        return file.lineStart(position.getLine() + 1) + position.getCharacter();
    }

    /** Does edits that do not overlap: the last one first, so that places stay what they are. */
    void apply(String path, List<? extends TextEdit> edits) {
        edits.stream()
                .sorted(
                        Comparator.comparing(
                                        (TextEdit edit) -> edit.getRange().getStart().getLine())
                                .thenComparing(edit -> edit.getRange().getStart().getCharacter())
                                .reversed())
                .forEach(edit -> replace(path, edit.getRange(), edit.getNewText()));
    }

    /** Files that are not open are opened for it. */
    void apply(WorkspaceEdit edit) throws IOException {
        if (edit.getDocumentChanges() == null) {
            for (Map.Entry<String, List<TextEdit>> each : edit.getChanges().entrySet()) {
                applyOpened(path(each.getKey()), each.getValue());
            }
            return;
        }
        for (Either<TextDocumentEdit, ResourceOperation> each : edit.getDocumentChanges()) {
            if (each.isLeft()) {
                TextDocumentEdit texts = each.getLeft();
                applyOpened(
                        path(texts.getTextDocument().getUri()),
                        texts.getEdits().stream().map(Either::getLeft).toList());
            } else {
                move((RenameFile) each.getRight());
            }
        }
    }

    private void applyOpened(String path, List<TextEdit> edits) throws IOException {
        if (!open.containsKey(path)) {
            open(path);
        }
        apply(path, edits);
    }

    /** As editors do: the text on the screen goes to the new place. */
    private void move(RenameFile operation) throws IOException {
        String from = path(operation.getOldUri());
        String to = path(operation.getNewUri());
        Files.move(folder.resolve(from), folder.resolve(to));
        if (open.containsKey(from)) {
            Files.writeString(folder.resolve(to), text(from).text());
            close(from);
            open(to);
        }
    }

    List<Either<Command, CodeAction>> actions(String path, Range range, List<String> kinds) {
        CodeActionContext context = new CodeActionContext(List.of());
        if (!kinds.isEmpty()) {
            context.setOnly(kinds);
        }
        return actions(path, range, context);
    }

    List<Either<Command, CodeAction>> actions(String path, Range range, CodeActionContext context) {
        return get(
                server.getTextDocumentService()
                        .codeAction(new CodeActionParams(document(path), range, context)));
    }

    /** What the server has said about files, by their paths, after it has seen all edits. */
    Map<String, List<Diagnostic>> problems() {
        // Repairs are those of findings: once they are known, so are the findings.
        actions("none", new Range(new Position(0, 0), new Position(0, 0)), List.of());
        Map<String, List<Diagnostic>> shown = new TreeMap<>();
        problems.forEach(
                (address, found) -> {
                    if (!found.isEmpty()) {
                        shown.put(path(address), found);
                    }
                });
        return shown;
    }

    @Override
    public void publishDiagnostics(PublishDiagnosticsParams params) {
        problems.put(params.getUri(), params.getDiagnostics());
    }

    /** What the server has asked to be shown last. */
    Path shown() {
        return Path.of(URI.create(shown.get(shown.size() - 1)));
    }

    @Override
    public CompletableFuture<ShowDocumentResult> showDocument(ShowDocumentParams params) {
        shown.add(params.getUri());
        return CompletableFuture.completedFuture(new ShowDocumentResult(true));
    }

    @Override
    public void telemetryEvent(Object object) {}

    /** Settings name models of others; behind the first of the words. */
    void refersTo(String... words) {
        JsonArray folders = new JsonArray();
        Stream.of(words).skip(1).forEach(folders::add);
        JsonObject section = new JsonObject();
        section.add("libraries", folders);
        JsonObject settings = new JsonObject();
        settings.add("arcomat", section);
        server.getWorkspaceService()
                .didChangeConfiguration(new DidChangeConfigurationParams(settings));
    }

    /** The same after the server has done all that it was asked to. */
    List<String> toldSince() {
        problems();
        return messages().stream().map(each -> each.replace(folder + "/", "")).toList();
    }

    /** What it was told since it was last asked. */
    List<String> messages() {
        List<String> all = List.copyOf(messages);
        messages.removeAll(all);
        return all;
    }

    @Override
    public void showMessage(MessageParams params) {
        messages.add(params.getMessage());
    }

    @Override
    public CompletableFuture<MessageActionItem> showMessageRequest(
            ShowMessageRequestParams params) {
        return CompletableFuture.completedFuture(null);
    }

    @Override
    public void logMessage(MessageParams params) {}

    @Override
    public void close() {
        get(server.shutdown());
        server.exit();
    }
}
