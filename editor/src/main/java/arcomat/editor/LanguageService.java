package arcomat.editor;

import arcomat.editor.server.EditorConnection;
import arcomat.editor.server.EditorServer;
import arcomat.guest.host.Guests;

import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;

/** Serves one editor, as the Language Server Protocol 3.17 says. */
public final class LanguageService {
    private LanguageService() {}

    /**
     * Answers until the editor goes.
     *
     * @param version of the tool, for the editor's log
     * @param guests who bring laws and behaviour languages
     * @param libraries model roots of others that models may refer to, absolute
     * @return the exit status that the protocol asks for: 0 where the editor took its leave
     */
    public static int serve(
            InputStream in, OutputStream out, String version, Guests guests, List<Path> libraries)
            throws InterruptedException {
        EditorServer server = new EditorServer(version, guests, libraries);
        var launcher = EditorConnection.of(server, in, out);
        server.connect(launcher.getRemoteProxy());
        Future<Void> listening = launcher.startListening();
        // An editor that breaks down takes no leave: its end of the pipe is closed.
        Thread watcher = new Thread(() -> waitFor(listening, server), "end of input");
        watcher.setDaemon(true);
        watcher.start();
        try {
            return server.exitStatus().get();
        } catch (ExecutionException e) {
            throw new IllegalStateException(e);
        }
    }

    private static void waitFor(Future<Void> listening, EditorServer server) {
        try {
            listening.get();
        } catch (InterruptedException | ExecutionException over) {
            Thread.currentThread().interrupt();
        } finally {
            server.exit();
        }
    }
}
