package arcomat.agent.server;

import arcomat.agent.server.LineReader.Line;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;

import org.eclipse.lsp4j.jsonrpc.Endpoint;
import org.eclipse.lsp4j.jsonrpc.MessageIssueException;
import org.eclipse.lsp4j.jsonrpc.RemoteEndpoint;
import org.eclipse.lsp4j.jsonrpc.json.JsonRpcMethod;
import org.eclipse.lsp4j.jsonrpc.json.MessageJsonHandler;
import org.eclipse.lsp4j.jsonrpc.messages.CancelParams;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.jsonrpc.messages.Message;
import org.eclipse.lsp4j.jsonrpc.messages.NotificationMessage;
import org.eclipse.lsp4j.jsonrpc.messages.RequestMessage;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.StringReader;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * JSON-RPC with a message on each line, which is how agents talk to a program that they have
 * started; editors have headers instead.
 */
public final class LineConnection {
    /** As the protocol for agents calls it; the library calls it otherwise. */
    private static final String CANCELLED = "notifications/cancelled";

    private final LineReader in;
    private final MessageJsonHandler json = new MessageJsonHandler(methods());
    private final Outbox outbox;

    public LineConnection(InputStream in, OutputStream out) {
        this.in = new LineReader(in);
        this.outbox = new Outbox(out, json);
    }

    private static Map<String, JsonRpcMethod> methods() {
        Map<String, JsonRpcMethod> methods = new LinkedHashMap<>();
        for (String name : ToolServer.METHODS) {
            methods.put(name, JsonRpcMethod.request(name, JsonElement.class, JsonElement.class));
        }
        methods.put(CANCELLED, JsonRpcMethod.notification(CANCELLED, JsonElement.class));
        return methods;
    }

    /** Reads to the end of the input, and returns when everything has its answer. */
    public void serve(Endpoint server) throws InterruptedException {
        RemoteEndpoint agent = new RemoteEndpoint(outbox, server, ToolServer::error);
        agent.setJsonHandler(json);
        json.setMethodProvider(agent);
        try {
            Optional<Line> line = in.next();
            while (line.isPresent()) {
                take(line.get(), agent);
                line = in.next();
            }
        } catch (IOException gone) {
            return; // nobody is there to be told
        }
        outbox.awaitEmpty();
    }

    private void take(Line line, RemoteEndpoint agent) {
        if (line.tooLong()) {
            outbox.refuse(
                    ResponseErrorCode.InvalidRequest,
                    "a message may have " + LineReader.LONGEST + " bytes, and no more");
        } else if (!line.text().isEmpty()) {
            take(line.text(), agent);
        }
    }

    private void take(String text, RemoteEndpoint agent) {
        try {
            Message message = json.parseMessage(text);
            if (message instanceof RequestMessage) {
                outbox.expectAnswer();
            }
            agent.consume(cancelling(message));
        } catch (MessageIssueException | JsonParseException | IllegalStateException e) {
            refuse(text);
        }
    }

    /** What is JSON at least is told apart from what is not, as JSON-RPC wants it. */
    private void refuse(String text) {
        if (isJson(text)) {
            outbox.refuse(ResponseErrorCode.InvalidRequest, "this line is no message of JSON-RPC");
        } else {
            outbox.refuse(ResponseErrorCode.ParseError, "this line is no JSON");
        }
    }

    private static boolean isJson(String text) {
        JsonReader reader = new JsonReader(new StringReader(text));
        reader.setStrictness(Strictness.STRICT);
        try {
            reader.skipValue();
            return reader.peek() == JsonToken.END_DOCUMENT;
        } catch (IOException e) {
            return false;
        }
    }

    private static Message cancelling(Message message) {
        if (!(message instanceof NotificationMessage told)
                || !told.getMethod().equals(CANCELLED)
                || !(told.getParams() instanceof JsonObject params)) {
            return message;
        }
        JsonElement id = params.get("requestId");
        CancelParams cancelled = new CancelParams();
        boolean isText = id != null && id.isJsonPrimitive() && id.getAsJsonPrimitive().isString();
        cancelled.setRawId(
                isText
                        ? Either.forLeft(id.getAsString())
                        : Either.forRight(
                                id == null || !id.isJsonPrimitive() ? -1 : id.getAsInt()));
        NotificationMessage cancel = new NotificationMessage();
        cancel.setMethod(MessageJsonHandler.CANCEL_METHOD.getMethodName());
        cancel.setParams(cancelled);
        return cancel;
    }
}
