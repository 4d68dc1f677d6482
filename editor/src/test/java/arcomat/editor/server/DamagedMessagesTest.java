package arcomat.editor.server;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.guest.host.Guests;

import com.google.gson.Gson;
import com.google.gson.JsonObject;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.Pipe;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;

/** Whatever an editor says, the server answers as the protocol wants it, and goes on. */
@Timeout(value = 300, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class DamagedMessagesTest {
    /** Sent before somebody looks at the answers. */
    private static final int BATCH = 20;

    /** Of JSON-RPC, then that a request fails, or is about a text that has changed. */
    private static final Set<Integer> CODES =
            Set.of(-32700, -32600, -32601, -32602, -32803, -32801, -32800);

    @TempDir private Path folder;
    private OutputStream toServer;
    private DataInputStream fromServer;
    private String address;

    /** A thread that ends by an exception leaves what it was told undone. */
    private final List<Throwable> uncaught = new CopyOnWriteArrayList<>();

    private final Thread.UncaughtExceptionHandler before =
            Thread.getDefaultUncaughtExceptionHandler();

    @BeforeEach
    void start() throws IOException {
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> uncaught.add(failure));
        Path file = folder.resolve("p/Door.arc");
        Files.createDirectories(file.getParent());
        Files.writeString(file, "package p;\ncomponent Door {\n    port in Integer bell;\n}\n");
        address = file.toUri().toString();
        Pipe in = Pipe.open();
        Pipe out = Pipe.open();
        toServer = Channels.newOutputStream(in.sink());
        fromServer = new DataInputStream(Channels.newInputStream(out.source()));
        EditorServer server = new EditorServer("0", Guests.NONE, List.of());
        var connection =
                EditorConnection.of(
                        server,
                        Channels.newInputStream(in.source()),
                        Channels.newOutputStream(out.sink()));
        server.connect(connection.getRemoteProxy());
        var unused = connection.startListening();
    }

    @AfterEach
    void end() throws IOException {
        ask("\"shutdown\"", "shutdown");
        toServer.close();
        Thread.setDefaultUncaughtExceptionHandler(before);
        assertThat(uncaught).isEmpty();
    }

    private void send(String message) throws IOException {
        byte[] content = message.getBytes(StandardCharsets.UTF_8);
        toServer.write(
                ("Content-Length: " + content.length + "\r\n\r\n")
                        .getBytes(StandardCharsets.US_ASCII));
        toServer.write(content);
        toServer.flush();
    }

    private JsonObject receive() throws IOException {
        int length = -1;
        String header = header();
        while (!header.isEmpty()) {
            if (header.startsWith("Content-Length: ")) {
                length = Integer.parseInt(header.substring(16));
            }
            header = header();
        }
        String text = new String(fromServer.readNBytes(length), StandardCharsets.UTF_8);
        return new Gson().fromJson(text, JsonObject.class);
    }

    private String header() throws IOException {
        StringBuilder line = new StringBuilder();
        char letter = (char) fromServer.readByte();
        while (letter != '\n') {
            line.append(letter);
            letter = (char) fromServer.readByte();
        }
        return line.toString().strip();
    }

    /** The answer to a whole question, past all others, which are looked at. */
    private JsonObject ask(String id, String method) throws IOException {
        send("{\"jsonrpc\":\"2.0\",\"id\":%s,\"method\":\"%s\"}".formatted(id, method));
        JsonObject answer = receive();
        while (!answer.has("id") || !answer.get("id").toString().equals(id)) {
            check(answer);
            answer = receive();
        }
        return answer;
    }

    private static void check(JsonObject message) {
        if (message.has("error")) {
            int code = message.getAsJsonObject("error").get("code").getAsInt();
            assertThat(CODES).as(message.toString()).contains(code);
        }
    }

    private void endNoServer(int count, long seed) throws IOException {
        DamagedMessages messages = new DamagedMessages(seed, address);
        for (int sent = 0; sent < count; sent += BATCH) {
            for (int i = 0; i < BATCH; i++) {
                send(messages.next());
            }
            ask("\"batch %d\"".formatted(sent), "textDocument/unknown");
        }
    }

    @Test
    void aFewEndNoServer() throws IOException {
        endNoServer(100, 1);
    }

    @Tag("slow")
    @Test
    void manyEndNoServer() throws IOException {
        endNoServer(5_000, 2);
    }

    private String refused(String message) throws IOException {
        send(message);
        JsonObject answer = receive();
        return answer.get("id") + " " + answer.getAsJsonObject("error").get("code");
    }

    @Test
    void whatIsNoRequestHasAnErrorForItsAnswer() throws IOException {
        String hover = "{\"jsonrpc\":\"2.0\",\"id\":%s,\"method\":\"textDocument/hover\"%s}";
        assertThat(refused(hover.formatted("1732800000000", ""))).isEqualTo("null -32600");
        assertThat(refused(hover.formatted("1.5", ""))).isEqualTo("null -32600");
        assertThat(refused(hover.formatted("null", ""))).isEqualTo("null -32600");
        assertThat(refused(hover.formatted("1", ""))).isEqualTo("1 -32602");
        assertThat(refused(hover.formatted("\"a\"", ",\"params\":{}"))).isEqualTo("\"a\" -32602");
        assertThat(refused(hover.formatted("2", ",\"params\":[1]"))).isEqualTo("2 -32602");
        assertThat(refused("{\"id\":3,\"method\":\"initialize\"}")).isEqualTo("3 -32600");
        assertThat(refused("{\"jsonrpc\":\"2.0\",\"id\":4}")).isEqualTo("4 -32600");
        assertThat(refused("{\"jsonrpc\":\"2.0\",\"id\":5,\"method\":\"initialize\"}"))
                .isEqualTo("5 -32602");
        assertThat(refused("{\"jsonrpc\":\"2.0\",\"id\":6,\"method\":\"textDocument/didOpen\"}"))
                .isEqualTo("6 -32600");
        assertThat(refused("[]")).isEqualTo("null -32600");
        assertThat(refused("what?")).isEqualTo("null -32700");
        assertThat(refused("{\"jsonrpc\":\"2.0\",\"id\":7,\"method\":\"arcomat/none\"}"))
                .isEqualTo("7 -32601");
    }
}
