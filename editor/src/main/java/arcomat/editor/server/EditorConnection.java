package arcomat.editor.server;

import org.eclipse.lsp4j.jsonrpc.Launcher;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.json.MessageJsonHandler;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.eclipse.lsp4j.services.LanguageClient;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.concurrent.RejectedExecutionException;

/** Between the server and an editor, of which nothing is expected to be as the protocol says. */
public final class EditorConnection {
    private EditorConnection() {}

    private static final class Checked extends Launcher.Builder<LanguageClient> {
        @Override
        protected MessageJsonHandler createJsonHandler() {
            return new CheckedMessages(getSupportedMethods());
        }
    }

    /** Makes the connection to an editor, which listens once it is told to. */
    public static Launcher<LanguageClient> of(
            EditorServer server, InputStream in, OutputStream out) {
        return new Checked()
                .setLocalService(server)
                .setRemoteInterface(LanguageClient.class)
                .setInput(in)
                .setOutput(out)
                .setExceptionHandler(EditorConnection::error)
                .create();
    }

    /** What is told of a request that fails. */
    private static ResponseError error(Throwable failure) {
        for (Throwable each = failure; each != null; each = each.getCause()) {
            if (each instanceof ResponseErrorException refused) {
                return refused.getResponseError();
            }
            if (each instanceof RejectedExecutionException) {
                return new ResponseError(
                        ResponseErrorCode.InvalidRequest, "the server has been shut down", null);
            }
        }
        return new ResponseError(
                ResponseErrorCode.InternalError,
                "internal error, this is a fault of arcomat (" + root(failure) + ")",
                null);
    }

    private static Throwable root(Throwable failure) {
        Throwable root = failure;
        while (root.getCause() != null) {
            root = root.getCause();
        }
        return root;
    }
}
