package arcomat.agent.server;

import com.google.gson.JsonElement;

import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;

/** Thrown for a line that is no message of JSON-RPC. */
final class RefusedMessage extends Exception {
    private static final long serialVersionUID = 1;

    private final transient JsonElement id;
    private final transient ResponseError error;

    /**
     * @param id null where it cannot be told
     */
    RefusedMessage(JsonElement id, ResponseErrorCode code, String why) {
        super(why, null, false, false);
        this.id = id;
        this.error = new ResponseError(code, why, null);
    }

    JsonElement id() {
        return id;
    }

    ResponseError error() {
        return error;
    }
}
