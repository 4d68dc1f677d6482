package arcomat.editor.server;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.guest.host.Guests;

import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializedParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.services.LanguageClient;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;

/** An editor is told nothing by itself before it has said that it is ready for it. */
class GreetingTest {
    private static final long SECONDS = 120;

    @TempDir private Path folder;
    private final EditorServer server = new EditorServer("0", Guests.NONE, List.of());
    private final List<String> told = new CopyOnWriteArrayList<>();

    @Test
    void findingsWaitUntilTheEditorIsReady() throws Exception {
        Files.writeString(
                folder.resolve("Door.arc"), "component Door {\n    port in Bell bell;\n}\n");
        server.connect(client());
        InitializeParams params = new InitializeParams();
        params.setCapabilities(new ClientCapabilities());
        params.setWorkspaceFolders(
                List.of(new WorkspaceFolder(folder.toUri().toString(), "folder")));
        server.initialize(params).get(SECONDS, TimeUnit.SECONDS);
        awaitFindings();
        assertThat(told).isEmpty();
        server.initialized(new InitializedParams());
        awaitFindings();
        assertThat(told).containsExactly("publishDiagnostics");
        server.shutdown();
    }

    /** Tells the names of what it is told. */
    private LanguageClient client() {
        return (LanguageClient)
                Proxy.newProxyInstance(
                        LanguageClient.class.getClassLoader(),
                        new Class<?>[] {LanguageClient.class},
                        (proxy, method, arguments) -> {
                            told.add(method.getName());
                            return null;
                        });
    }

    /** Repairs are those of findings: once they are known, so are the findings. */
    private void awaitFindings() throws Exception {
        Position start = new Position(0, 0);
        server.getTextDocumentService()
                .codeAction(
                        new CodeActionParams(
                                new TextDocumentIdentifier(
                                        folder.resolve("None.arc").toUri().toString()),
                                new Range(start, start),
                                new CodeActionContext(List.of())))
                .get(SECONDS, TimeUnit.SECONDS);
    }
}
