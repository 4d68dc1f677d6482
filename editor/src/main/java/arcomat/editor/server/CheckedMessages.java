package arcomat.editor.server;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonPrimitive;

import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.SetTraceParams;
import org.eclipse.lsp4j.jsonrpc.MessageIssueException;
import org.eclipse.lsp4j.jsonrpc.json.JsonRpcMethod;
import org.eclipse.lsp4j.jsonrpc.json.MessageJsonHandler;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.jsonrpc.messages.Message;
import org.eclipse.lsp4j.jsonrpc.messages.MessageIssue;
import org.eclipse.lsp4j.jsonrpc.messages.NotificationMessage;
import org.eclipse.lsp4j.jsonrpc.messages.RequestMessage;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.eclipse.lsp4j.jsonrpc.validation.ReflectiveMessageValidator;
import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.Reader;
import java.io.StringReader;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Reads what an editor says. A request that is none, or lacks parameters, has an error for its
 * answer; a notification of that kind is passed over, since nobody waits for an answer to it.
 */
final class CheckedMessages extends MessageJsonHandler {
    private static final String INITIALIZED = "initialized";
    private static final String TRACE = "$/setTrace";

    /** Below these stands what the protocol does not lay down. */
    private static final Set<String> FREE =
            Set.of("arguments", "capabilities", "data", "initializationOptions", "settings");

    private final ReflectiveMessageValidator validator = new ReflectiveMessageValidator(any -> {});

    CheckedMessages(Map<String, JsonRpcMethod> methods) {
        super(methods);
    }

    @Override
    public Message parseMessage(Reader message) {
        String text = text(message);
        if (!(json(text) instanceof JsonObject object)) {
            throw refused(null, ResponseErrorCode.InvalidRequest, "a message is an object");
        }
        if (!object.has("method") && (object.has("result") || object.has("error"))) {
            return response(text);
        }
        Either<String, Number> id = id(object);
        if (!isText(object.get("method"))
                || !new JsonPrimitive("2.0").equals(object.get("jsonrpc"))) {
            throw refused(
                    id,
                    ResponseErrorCode.InvalidRequest,
                    "a message has \"jsonrpc\":\"2.0\" and a method, which is a text");
        }
        try {
            return asked(text, object, id);
        } catch (MessageIssueException refused) {
            if (id == null) {
                return nothing();
            }
            throw refused;
        }
    }

    private static String text(Reader message) {
        try (message) {
            StringWriter text = new StringWriter();
            message.transferTo(text);
            return text.toString();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static JsonElement json(String text) {
        try {
            return new Gson().getAdapter(JsonElement.class).fromJson(text);
        } catch (IOException | JsonParseException | IllegalStateException noJson) {
            throw refused(null, ResponseErrorCode.ParseError, "this is no JSON");
        }
    }

    /** Reads the answer to a question of the server; one that cannot be read answers nothing. */
    private Message response(String text) {
        try {
            return super.parseMessage(new StringReader(text));
        } catch (RuntimeException odd) {
            return nothing();
        }
    }

    /** The protocol has texts and numbers of 31 bits; nothing for a notification. */
    private static @Nullable Either<String, Number> id(JsonObject message) {
        JsonElement id = message.get("id");
        if (id == null) {
            return null;
        }
        if (isText(id)) {
            return Either.forLeft(id.getAsString());
        }
        try {
            if (id instanceof JsonPrimitive given && given.isNumber()) {
                return Either.forRight(new BigDecimal(given.getAsString()).intValueExact());
            }
        } catch (ArithmeticException | NumberFormatException tooLarge) {
            // Told below, as what is no number.
        }
        throw refused(
                null,
                ResponseErrorCode.InvalidRequest,
                "an id is a text, or a whole number from -2147483648 to 2147483647");
    }

    private Message asked(String text, JsonObject object, @Nullable Either<String, Number> id) {
        String method = object.get("method").getAsString();
        JsonRpcMethod known = getJsonRpcMethod(method);
        if (known != null && known.isNotification() && id != null) {
            throw refused(
                    id,
                    ResponseErrorCode.InvalidRequest,
                    "'" + method + "' is a notification, which has no id");
        }
        if (known != null && !known.isNotification() && id == null) {
            return nothing(); // nobody waits for the answer
        }
        if (known != null && known.getParameterTypes().length > 0) {
            checkForm(object.get("params"), method, id);
        }
        return valid(text, method, id);
    }

    private static void checkForm(
            @Nullable JsonElement params, String method, @Nullable Either<String, Number> id) {
        if (params == null || params.isJsonNull()) {
            if (!method.equals(INITIALIZED)) {
                throw wrong(id, method, "are missing");
            }
        } else if (!params.isJsonObject() || hasGap(params)) {
            throw wrong(id, method, "are no object, or have null in a list");
        }
    }

    private Message valid(String text, String method, @Nullable Either<String, Number> id) {
        try {
            Message message = super.parseMessage(new StringReader(text));
            validator.consume(whatIsChecked(message));
            return message;
        } catch (MessageIssueException e) {
            throw wrong(id, method, "are not those of the protocol: " + reasons(e));
        } catch (RuntimeException e) { // of a number that is none, of a kind that is not known
            throw wrong(id, method, "are not those of the protocol");
        }
    }

    private static String reasons(MessageIssueException refused) {
        return refused.getIssues().stream()
                .map(MessageIssue::getText)
                .collect(Collectors.joining("; "));
    }

    /** Editors differ in what they say of themselves, and nobody is refused for that. */
    private static Message whatIsChecked(Message message) {
        if (!(message instanceof RequestMessage request)
                || !(request.getParams() instanceof InitializeParams said)) {
            return message;
        }
        InitializeParams checked = new InitializeParams();
        checked.setCapabilities(new ClientCapabilities());
        checked.setWorkspaceFolders(said.getWorkspaceFolders());
        RequestMessage copy = new RequestMessage();
        copy.setRawId(request.getRawId());
        copy.setMethod(request.getMethod());
        copy.setParams(checked);
        return copy;
    }

    private static boolean hasGap(JsonElement value) {
        if (value instanceof JsonArray list) {
            return list.asList().stream().anyMatch(each -> each.isJsonNull() || hasGap(each));
        }
        return value instanceof JsonObject object
                && object.entrySet().stream()
                        .anyMatch(each -> !FREE.contains(each.getKey()) && hasGap(each.getValue()));
    }

    private static boolean isText(@Nullable JsonElement value) {
        return value instanceof JsonPrimitive given && given.isString();
    }

    private static MessageIssueException wrong(
            @Nullable Either<String, Number> id, String method, String how) {
        return refused(
                id, ResponseErrorCode.InvalidParams, "the parameters of '" + method + "' " + how);
    }

    private static MessageIssueException refused(
            @Nullable Either<String, Number> id, ResponseErrorCode code, String why) {
        RequestMessage request = new RequestMessage();
        if (id != null) {
            request.setRawId(id);
        }
        return new MessageIssueException(request, new MessageIssue(why, code.getValue()));
    }

    /** A message that changes nothing. */
    private static Message nothing() {
        NotificationMessage nothing = new NotificationMessage();
        nothing.setMethod(TRACE);
        nothing.setParams(new SetTraceParams("off"));
        return nothing;
    }
}
