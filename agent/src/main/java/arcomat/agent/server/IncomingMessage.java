package arcomat.agent.server;

import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;

import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.jspecify.annotations.Nullable;

import java.util.Optional;

/**
 * A request or a notification of JSON-RPC 2.0.
 *
 * @param id of a request, a text or a number of any size, which its answer repeats letter for
 *     letter; empty for a notification
 * @param params an object or an array, where there are some
 */
record IncomingMessage(Optional<JsonPrimitive> id, String method, @Nullable JsonElement params) {
    private static final String ID = "id";
    private static final String METHOD = "method";
    private static final String PARAMS = "params";

    /**
     * Reads a line.
     *
     * @return empty for an answer: the server asks nothing
     */
    static Optional<IncomingMessage> read(String line) throws RefusedMessage {
        JsonElement json =
                JsonText.read(line)
                        .orElseThrow(
                                () ->
                                        new RefusedMessage(
                                                JsonNull.INSTANCE,
                                                ResponseErrorCode.ParseError,
                                                "this line is no JSON"));
        if (!(json instanceof JsonObject object)) {
            throw invalid(JsonNull.INSTANCE, "a message is an object, one on each line");
        }
        JsonElement id = id(object);
        if (!isText(object.get("jsonrpc")) || !object.get("jsonrpc").getAsString().equals("2.0")) {
            throw invalid(id, "a message has \"jsonrpc\":\"2.0\"");
        }
        if (!object.has(METHOD) && (object.has("result") || object.has("error"))) {
            return Optional.empty();
        }
        return Optional.of(
                new IncomingMessage(
                        id instanceof JsonPrimitive given ? Optional.of(given) : Optional.empty(),
                        method(object, id),
                        params(object, id)));
    }

    /** Null where there is none. */
    private static JsonElement id(JsonObject message) throws RefusedMessage {
        JsonElement id = message.get(ID);
        if (id != null && !isText(id) && !isNumber(id)) {
            throw invalid(JsonNull.INSTANCE, "an id is a text or a number");
        }
        return id == null ? JsonNull.INSTANCE : id;
    }

    private static String method(JsonObject message, JsonElement id) throws RefusedMessage {
        if (!isText(message.get(METHOD))) {
            throw invalid(id, "a message has a method, which is a text");
        }
        return message.get(METHOD).getAsString();
    }

    private static @Nullable JsonElement params(JsonObject message, JsonElement id)
            throws RefusedMessage {
        JsonElement params = message.get(PARAMS);
        if (params == null || params.isJsonNull()) {
            return null;
        }
        if (params.isJsonPrimitive()) {
            throw invalid(id, "the parameters of a message are an object");
        }
        return params;
    }

    private static boolean isText(@Nullable JsonElement value) {
        return value instanceof JsonPrimitive given && given.isString();
    }

    private static boolean isNumber(JsonElement value) {
        return value instanceof JsonPrimitive given && given.isNumber();
    }

    private static RefusedMessage invalid(JsonElement id, String why) {
        return new RefusedMessage(id, ResponseErrorCode.InvalidRequest, why);
    }
}
