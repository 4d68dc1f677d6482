package arcomat.agent;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;

/** Tests that the server answers each damaged line as the protocol says, and reads the next. */
class DamagedRequestsTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int SECONDS = 60;
    private static final int LONGEST = 2500;

    /** Requests that are sent before somebody looks at the answers. */
    private static final int BATCH = 50;

    private static final Set<Integer> CODES = Set.of(-32700, -32600, -32601, -32602);

    @TempDir private Path folder;

    @BeforeEach
    void writeModel() throws IOException {
        Path file = folder.resolve("models/p/Door.arc");
        Files.createDirectories(file.getParent());
        Files.writeString(
                file,
                """
                package p;
                component Door {
                    timing instant;
                    port in Boolean pressed, out Boolean opens;
                    <<completion="ignore">> automaton {
                        state closed;
                        initial closed;
                        closed {pressed == true} / {opens = true};
                    }
                }
                """);
    }

    @Test
    void aFewEndNoServer() throws IOException {
        endNoServer(100, 1);
    }

    @Tag("slow")
    @Test
    void manyEndNoServer() throws IOException {
        endNoServer(10_000, 2);
    }

    private void endNoServer(int count, long seed) throws IOException {
        DamagedRequests requests = new DamagedRequests(seed);
        try (AgentClient client = new AgentClient(folder, List.of("models"), SECONDS, LONGEST)) {
            client.greet();
            for (int sent = 0; sent < count; sent += BATCH) {
                for (int i = 0; i < BATCH; i++) {
                    client.send(requests.next());
                }
                String last = "\"batch %d\"".formatted(sent);
                client.send("{\"jsonrpc\":\"2.0\",\"id\":%s,\"method\":\"ping\"}".formatted(last));
                String answer = client.receive();
                while (!answer.contains("\"id\":" + last)) {
                    check(answer);
                    answer = client.receive();
                }
            }
            for (String answer : client.leave()) {
                check(answer);
            }
        }
    }

    private static void check(String answer) throws IOException {
        JsonNode message = JSON.readTree(answer);
        assertThat(message.path("jsonrpc").asText()).as(answer).isEqualTo("2.0");
        assertThat(message.has("id")).as(answer).isTrue();
        assertThat(message.has("result") != message.has("error")).as(answer).isTrue();
        if (message.has("error")) {
            assertThat(CODES).as(answer).contains(message.get("error").get("code").asInt());
        }
        assertThat(answer).doesNotContain("internal error");
    }
}
