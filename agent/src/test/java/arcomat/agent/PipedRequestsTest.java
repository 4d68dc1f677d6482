package arcomat.agent;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** Requests of a program that does not wait for answers, and of one that is none. */
class PipedRequestsTest {
    private static final int LONGEST = 10_000;

    private static AgentClient client() throws IOException {
        Path here = Path.of("").toAbsolutePath();
        AgentClient client = new AgentClient(here, List.of("models/coffee"), 60, LONGEST);
        client.greet();
        return client;
    }

    @Tag("slow")
    @Test
    void everythingIsAnsweredBeforeTheServerGoes() throws IOException {
        try (AgentClient client = client()) {
            for (int i = 1; i <= 3; i++) {
                client.send(
                        """
                        {"jsonrpc":"2.0","id":%d,"method":"tools/call",\
                        "params":{"name":"check","arguments":{}}}\
                        """
                                .formatted(i));
            }
            List<String> answers = client.leave();
            assertThat(answers).hasSize(3);
            assertThat(answers).allSatisfy(each -> assertThat(each).contains("\"isError\":false"));
        }
    }

    @Test
    void aLineWithoutAnEndIsRefusedAndTheNextOneRead() throws IOException {
        try (AgentClient client = client()) {
            client.send("x".repeat((1 << 20) + 1));
            client.send("{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"ping\"}");
            assertThat(client.receive()).contains("a message may have 1048576 bytes");
            assertThat(client.receive()).isEqualTo("{\"jsonrpc\":\"2.0\",\"id\":1,\"result\":{}}");
        }
    }

    @Test
    void whatIsCancelledHasNoAnswer() throws IOException {
        try (AgentClient client = client()) {
            client.send(
                    """
                    {"jsonrpc":"2.0","id":"a","method":"tools/call","params":{"name":"simulate",\
                    "arguments":{"component":"coffee.fetcher.Fetcher","slices":1000000}}}\
                    """);
            client.send(
                    """
                    {"jsonrpc":"2.0","method":"notifications/cancelled",\
                    "params":{"requestId":"a"}}\
                    """);
            client.send("{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"ping\"}");
            assertThat(client.leave())
                    .containsExactly("{\"jsonrpc\":\"2.0\",\"id\":1,\"result\":{}}");
        }
    }
}
