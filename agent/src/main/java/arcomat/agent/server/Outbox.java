package arcomat.agent.server;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;

import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Writes messages to the agent, one on each line, from any thread. */
final class Outbox {
    private final OutputStream out;
    private int expected;

    Outbox(OutputStream out) {
        this.out = out;
    }

    /** A request has come. */
    synchronized void expectAnswer() {
        expected++;
    }

    /** Returns when each request has its answer. */
    synchronized void awaitEmpty() throws InterruptedException {
        while (expected > 0) {
            wait();
        }
    }

    /** Answers a request. */
    synchronized void answer(JsonElement id, JsonElement result) {
        settle();
        write(id, "result", result);
    }

    /** Answers a request that cannot be answered otherwise. */
    synchronized void fail(JsonElement id, ResponseError error) {
        settle();
        refuse(id, error);
    }

    /** The agent does not wait for an answer any more. */
    synchronized void settle() {
        expected--;
        notifyAll();
    }

    /** Answers what is no message. */
    synchronized void refuse(JsonElement id, ResponseError error) {
        JsonObject told = new JsonObject();
        told.addProperty("code", error.getCode());
        told.addProperty("message", error.getMessage());
        write(id, "error", told);
    }

    private void write(JsonElement id, String what, JsonElement content) {
        JsonObject message = new JsonObject();
        message.addProperty("jsonrpc", "2.0");
        message.add("id", id);
        message.add(what, content);
        try {
            out.write((JsonText.write(message) + "\n").getBytes(StandardCharsets.UTF_8));
            out.flush();
        } catch (IOException gone) {
            throw new UncheckedIOException(gone);
        }
    }
}
