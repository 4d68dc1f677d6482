package arcomat.agent.server;

import arcomat.agent.server.LineReader.Line;

import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;

import org.eclipse.lsp4j.jsonrpc.Endpoint;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;

/**
 * JSON-RPC with a message on each line, which is how agents talk to a program that they have
 * started; editors have headers instead. No line ends it.
 */
public final class LineConnection {
    private static final String CANCELLED = "notifications/cancelled";

    private final LineReader in;
    private final Outbox outbox;

    /** The requests that are not answered yet, by the texts of their ids. */
    private final Map<String, CompletableFuture<?>> open = new ConcurrentHashMap<>();

    public LineConnection(InputStream in, OutputStream out) {
        this.in = new LineReader(in);
        this.outbox = new Outbox(out);
    }

    /** Reads to the end of the input, and returns when everything has its answer. */
    public void serve(Endpoint server) throws InterruptedException {
        try {
            Optional<Line> line = in.next();
            while (line.isPresent()) {
                take(line.get(), server);
                line = in.next();
            }
        } catch (IOException | UncheckedIOException gone) {
            return; // nobody is there to be told
        }
        outbox.awaitEmpty();
    }

    private void take(Line line, Endpoint server) {
        if (line.tooLong()) {
            outbox.refuse(
                    JsonNull.INSTANCE,
                    new ResponseError(
                            ResponseErrorCode.InvalidRequest,
                            "a message may have " + LineReader.LONGEST + " bytes, and no more",
                            null));
        } else if (!line.text().isEmpty()) {
            take(line.text(), server);
        }
    }

    private void take(String text, Endpoint server) {
        try {
            IncomingMessage.read(text).ifPresent(message -> take(message, server));
        } catch (RefusedMessage e) {
            outbox.refuse(e.id(), e.error());
        }
    }

    private void take(IncomingMessage message, Endpoint server) {
        if (message.id().isPresent()) {
            answer(message.id().get(), asked(message, server));
        } else if (message.method().equals(CANCELLED)) {
            cancel(message.params());
        } else {
            server.notify(message.method(), message.params());
        }
    }

    private static CompletableFuture<?> asked(IncomingMessage message, Endpoint server) {
        try {
            return server.request(message.method(), message.params());
        } catch (RuntimeException | Error e) { // one request that fails does not end the others
            return CompletableFuture.failedFuture(e);
        }
    }

    private void answer(JsonPrimitive id, CompletableFuture<?> answer) {
        String key = id.toString();
        outbox.expectAnswer();
        open.put(key, answer);
        var unused =
                answer.whenComplete(
                        (result, failure) -> {
                            open.remove(key, answer);
                            tell(id, result, failure);
                        });
    }

    private void tell(JsonPrimitive id, @Nullable Object result, @Nullable Throwable failure) {
        if (failure == null) {
            outbox.answer(id, result instanceof JsonElement json ? json : JsonNull.INSTANCE);
        } else if (isCancelled(failure)) {
            outbox.settle();
        } else {
            outbox.fail(id, ToolServer.error(failure));
        }
    }

    private static boolean isCancelled(Throwable failure) {
        return failure instanceof CancellationException
                || failure instanceof CompletionException
                        && failure.getCause() instanceof CancellationException;
    }

    private void cancel(@Nullable JsonElement params) {
        JsonElement id = params instanceof JsonObject told ? told.get("requestId") : null;
        CompletableFuture<?> answer = id == null ? null : open.get(id.toString());
        if (answer != null) {
            answer.cancel(true);
        }
    }
}
