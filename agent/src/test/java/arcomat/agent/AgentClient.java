package arcomat.agent;

import arcomat.pipeline.Fence;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;

/** An agent without wits: it sends lines and reads lines, through the pipes of a server. */
final class AgentClient implements AutoCloseable {
    private static final int PIPE_BYTES = 1 << 22;
    private static final long PATIENCE_MILLISECONDS = 120_000;
    private static final ObjectMapper JSON = new ObjectMapper();

    private final PipedOutputStream toServer;
    private final BufferedReader fromServer;
    private final Thread serving;
    private int calls;
    private boolean greeted;

    /**
     * @param folder that the server is started in
     * @param roots below it
     */
    AgentClient(Path folder, List<String> roots, int seconds, int longest) throws IOException {
        Fence fence = Fence.around(roots.stream().map(folder::resolve).toList(), roots);
        Session session = new Session(new PathNames(folder, fence), Progress.NONE);
        AgentTerms terms = new AgentTerms(session, roots, Duration.ofSeconds(seconds), longest);
        PipedInputStream in = new PipedInputStream(PIPE_BYTES);
        PipedInputStream out = new PipedInputStream(PIPE_BYTES);
        this.toServer = new PipedOutputStream(in);
        PipedOutputStream answers = new PipedOutputStream(out);
        this.fromServer = new BufferedReader(new InputStreamReader(out, StandardCharsets.UTF_8));
        this.serving =
                new Thread(
                        () -> {
                            try (answers) {
                                AgentService.serve(in, answers, terms, "VERSION");
                            } catch (IOException | InterruptedException e) {
                                throw new IllegalStateException(e);
                            }
                        });
        serving.start();
    }

    void send(String line) throws IOException {
        greeted |= line.contains("\"initialize\"");
        toServer.write((line + "\n").getBytes(StandardCharsets.UTF_8));
        toServer.flush();
    }

    /** The next line of the server. */
    String receive() throws IOException {
        String line = fromServer.readLine();
        if (line == null) {
            throw new IOException("the server has gone");
        }
        return line;
    }

    /** Begins as the protocol wants it, if nothing has been begun. */
    void greet() throws IOException {
        if (!greeted) {
            send("{\"jsonrpc\":\"2.0\",\"id\":0,\"method\":\"initialize\",\"params\":{}}");
            receive();
        }
    }

    /** The result of a tool. */
    JsonNode call(String tool, String arguments) throws IOException {
        greet();
        ObjectNode request = JSON.createObjectNode();
        request.put("jsonrpc", "2.0").put("id", ++calls).put("method", "tools/call");
        request.putObject("params").put("name", tool).set("arguments", JSON.readTree(arguments));
        send(request.toString());
        return JSON.readTree(receive()).get("result");
    }

    /** Says that nothing more comes, and returns what does. */
    List<String> leave() throws IOException {
        toServer.close();
        return fromServer.lines().toList();
    }

    @Override
    public void close() throws IOException {
        toServer.close();
        try {
            serving.join(PATIENCE_MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (serving.isAlive()) {
            throw new AssertionError("the server stays when its agent has gone");
        }
    }
}
