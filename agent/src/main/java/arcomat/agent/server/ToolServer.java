package arcomat.agent.server;

import arcomat.agent.server.Workshop.Outcome;
import arcomat.agent.tool.LongAnswers;
import arcomat.agent.tool.Tool;
import arcomat.agent.tool.ToolAnswer;
import arcomat.agent.tool.Toolbox;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;

import org.eclipse.lsp4j.jsonrpc.Endpoint;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

/** The requests of the protocol: who we are, which tools there are, and calls of them. */
public final class ToolServer implements Endpoint {
    private static final String INITIALIZE = "initialize";
    private static final String PING = "ping";
    private static final String LIST = "tools/list";
    private static final String CALL = "tools/call";

    /** What can be asked for. */
    private static final Set<String> METHODS = Set.of(INITIALIZE, PING, LIST, CALL);

    /** What may come before the first of them. */
    private static final Set<String> UNGREETED = Set.of(INITIALIZE, PING);

    private final Workshop workshop;
    private final Greeting greeting;
    private final LongAnswers answers;
    private final List<Tool> tools;
    private boolean greeted;

    /**
     * @param longest characters of an answer; what is longer comes in parts
     * @param version of the tool
     */
    public ToolServer(Workshop workshop, int longest, String version) {
        this.workshop = workshop;
        this.greeting = new Greeting(version);
        this.answers = new LongAnswers(longest);
        this.tools = Toolbox.all(answers);
    }

    @Override
    public CompletableFuture<?> request(String method, @Nullable Object params) {
        if (!greeted && METHODS.contains(method) && !UNGREETED.contains(method)) {
            return refused(
                    ResponseErrorCode.InvalidRequest,
                    "'" + method + "' comes before '" + INITIALIZE + "': begin with that");
        }
        if (METHODS.contains(method) && params != null && !(params instanceof JsonObject)) {
            return refused(
                    ResponseErrorCode.InvalidParams,
                    "the parameters of '" + method + "' are no object");
        }
        JsonObject told = params instanceof JsonObject object ? object : new JsonObject();
        greeted |= method.equals(INITIALIZE);
        return switch (method) {
            case INITIALIZE -> CompletableFuture.completedFuture(greeting.answer(told));
            case PING -> CompletableFuture.completedFuture(new JsonObject());
            case LIST -> CompletableFuture.completedFuture(ToolSchemas.list(tools));
            case CALL -> call(told);
            default ->
                    refused(
                            ResponseErrorCode.MethodNotFound,
                            "there is no method '" + method + "'");
        };
    }

    /** What the agent tells of itself changes nothing. */
    @Override
    public void notify(String method, @Nullable Object params) {}

    private CompletableFuture<?> call(JsonObject params) {
        JsonElement name = params.get("name");
        JsonElement arguments = params.get("arguments");
        for (Tool each : tools) {
            if (name != null && name.isJsonPrimitive() && name.getAsString().equals(each.name())) {
                return call(each, arguments);
            }
        }
        List<String> names = tools.stream().map(Tool::name).toList();
        return refused(
                ResponseErrorCode.InvalidParams,
                (name == null
                                ? "the parameter 'name' is missing; there are the tools "
                                : "there is no tool " + name + ", only ")
                        + String.join(", ", names));
    }

    private CompletableFuture<?> call(Tool tool, @Nullable JsonElement arguments) {
        if (arguments == null || arguments.isJsonNull()) {
            return call(tool, new JsonObject());
        }
        return arguments.isJsonObject()
                ? call(tool, arguments.getAsJsonObject())
                : refused(ResponseErrorCode.InvalidParams, "the arguments are no object");
    }

    private CompletableFuture<?> call(Tool tool, JsonObject arguments) {
        CompletableFuture<Outcome> outcome = workshop.call(tool, arguments);
        CompletableFuture<JsonObject> result = outcome.thenApply(this::result);
        // The library cancels what it was given.
        var unused =
                result.whenComplete(
                        (any, error) -> {
                            if (result.isCancelled()) {
                                outcome.cancel(true);
                            }
                        });
        return result;
    }

    private JsonObject result(Outcome outcome) {
        ToolAnswer answer = answers.begin(outcome.answer());
        JsonArray content = new JsonArray();
        content.add(text(answer.text()));
        answer.remarks().forEach(remark -> content.add(text(remark)));
        JsonObject result = new JsonObject();
        result.add("content", content);
        result.addProperty("isError", outcome.failed());
        return result;
    }

    private static JsonObject text(String text) {
        JsonObject content = new JsonObject();
        content.addProperty("type", "text");
        content.addProperty("text", text);
        return content;
    }

    private static CompletableFuture<?> refused(ResponseErrorCode code, String why) {
        return CompletableFuture.failedFuture(
                new ResponseErrorException(new ResponseError(code, why, null)));
    }

    /** What is told of a request that fails otherwise than by its tool. */
    static ResponseError error(Throwable failure) {
        Throwable cause =
                failure instanceof CompletionException && failure.getCause() != null
                        ? failure.getCause()
                        : failure;
        return cause instanceof ResponseErrorException refused
                ? refused.getResponseError()
                : new ResponseError(
                        ResponseErrorCode.InternalError,
                        "internal error, this is a fault of arcomat (" + cause + ")",
                        null);
    }
}
