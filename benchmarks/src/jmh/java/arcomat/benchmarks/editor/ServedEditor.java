package arcomat.benchmarks.editor;

import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializedParams;
import org.eclipse.lsp4j.MessageActionItem;
import org.eclipse.lsp4j.MessageParams;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.ShowMessageRequestParams;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.TextDocumentItem;
import org.eclipse.lsp4j.VersionedTextDocumentIdentifier;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.launch.LSPLauncher;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.LanguageServer;
import org.eclipse.lsp4j.services.TextDocumentService;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** An editor without a screen, with the installed tool as its server. */
final class ServedEditor implements LanguageClient, AutoCloseable {
    private static final long PATIENCE_SECONDS = 120;

    private final Path folder;
    private final Process process;
    private final LanguageServer server;
    private final boolean hovers;
    private final BlockingQueue<PublishDiagnosticsParams> published = new LinkedBlockingQueue<>();
    private final Map<String, Integer> versions = new HashMap<>();

    /** Starts the server; it answers when it has been asked for its abilities. */
    ServedEditor(Path tool, Path folder) throws IOException {
        this.folder = folder;
        process =
                new ProcessBuilder(tool.toString(), "language-server")
                        .redirectError(ProcessBuilder.Redirect.INHERIT)
                        .start();
        var launcher =
                LSPLauncher.createClientLauncher(
                        this, process.getInputStream(), process.getOutputStream());
        server = launcher.getRemoteProxy();
        launcher.startListening();
        InitializeParams params = new InitializeParams();
        params.setCapabilities(new ClientCapabilities());
        params.setWorkspaceFolders(
                List.of(new WorkspaceFolder(folder.toUri().toString(), "workshop")));
        hovers = get(server.initialize(params)).getCapabilities().getHoverProvider() != null;
        server.initialized(new InitializedParams());
    }

    static <T> T get(CompletableFuture<T> answer) {
        try {
            return answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Whether the server tells about what is under the cursor. */
    boolean hovers() {
        return hovers;
    }

    TextDocumentService documents() {
        return server.getTextDocumentService();
    }

    String address(String path) {
        return folder.resolve(path).toUri().toString();
    }

    TextDocumentIdentifier document(String path) {
        return new TextDocumentIdentifier(address(path));
    }

    void open(String path, String text) {
        versions.put(path, 1);
        var document = new TextDocumentItem(address(path), "arcomat", 1, text);
        documents().didOpen(new DidOpenTextDocumentParams(document));
    }

    void replace(String path, Range range, String text) {
        int version = versions.merge(path, 1, Integer::sum);
        documents()
                .didChange(
                        new DidChangeTextDocumentParams(
                                new VersionedTextDocumentIdentifier(address(path), version),
                                List.of(new TextDocumentContentChangeEvent(range, text))));
    }

    /** The next findings that are published about a file. */
    List<Diagnostic> awaitFindings(String path) {
        try {
            while (true) {
                var next = published.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
                if (next == null) {
                    throw new IllegalStateException("no findings about " + path);
                }
                if (next.getUri().equals(address(path))) {
                    return next.getDiagnostics();
                }
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** What the process has taken of the machine's memory so far, at most; in MB. */
    double megabytes() throws IOException {
        return Files.readAllLines(Path.of("/proc/" + process.pid() + "/status")).stream()
                .filter(line -> line.startsWith("VmHWM"))
                .mapToDouble(line -> Double.parseDouble(line.replaceAll("\\D", "")) / 1024)
                .findFirst()
                .orElseThrow();
    }

    @Override
    public void publishDiagnostics(PublishDiagnosticsParams params) {
        published.add(params);
    }

    @Override
    public void telemetryEvent(Object object) {}

    @Override
    public void showMessage(MessageParams params) {}

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
        try {
            process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
