package arcomat.agent.server;

import org.eclipse.lsp4j.jsonrpc.MessageConsumer;
import org.eclipse.lsp4j.jsonrpc.json.MessageJsonHandler;
import org.eclipse.lsp4j.jsonrpc.messages.Message;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseMessage;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** What goes to the agent, a message on each line, whichever thread has it. */
final class Outbox implements MessageConsumer {
    private final OutputStream out;
    private final MessageJsonHandler json;
    private int expected;

    Outbox(OutputStream out, MessageJsonHandler json) {
        this.out = out;
        this.json = json;
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

    @Override
    public synchronized void consume(Message message) {
        if (message instanceof ResponseMessage answer) {
            expected--;
            notifyAll();
            if (isCancelled(answer)) {
                return; // the agent does not wait for it any more
            }
        }
        write(message);
    }

    private static boolean isCancelled(ResponseMessage answer) {
        return answer.getError() != null
                && answer.getError().getCode() == ResponseErrorCode.RequestCancelled.getValue();
    }

    /** Answers what is no message. */
    synchronized void refuse(ResponseErrorCode code, String why) {
        ResponseMessage answer = new ResponseMessage();
        answer.setError(new ResponseError(code, why, null));
        write(answer);
    }

    private void write(Message message) {
        byte[] line = (json.serialize(message) + "\n").getBytes(StandardCharsets.UTF_8);
        try {
            out.write(line);
            out.flush();
        } catch (IOException gone) {
            throw new UncheckedIOException(gone);
        }
    }
}
