package arcomat.editor.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import arcomat.report.page.Browser;

import com.fasterxml.jackson.databind.ObjectMapper;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The extension in VS Code: in a browser, by code-server, which {@code
 * editors/vscode/test/workbench/install} installs in the folder that ARCOMAT_CODE_SERVER names.
 * What it looks like is then in {@code build/reports/pages}.
 */
@Tag("editor")
class WorkbenchTest {
    private static final String VARIABLE = "ARCOMAT_CODE_SERVER";
    private static final Path SCRIPT = Path.of("editor/src/test/resources/vscode/drive.txt");
    private static final String COMMAND =
            Path.of("build/install/arcomat/bin/arcomat").toAbsolutePath().toString();

    /** The first start reads everything from the disk. */
    private static final Duration PATIENCE = Duration.ofSeconds(90);

    @TempDir private Path folder;

    @Test
    void modelsAreBrokenMendedRenamedDrawnAndTested() throws Exception {
        Optional<Path> codeServer = codeServer();
        assumeTrue(codeServer.isPresent(), VARIABLE + " names no folder with code-server");
        assumeTrue(Browser.isThere(), "chromium and chromedriver are not installed");
        run(Path.of(""), "editors/vscode/pack", folder.toString(), "0.0.1");
        run(Files.createDirectory(folder.resolve("models")), COMMAND, "new", "mower");
        int port = freePort();
        Process server = start(codeServer.get(), port);
        try (Browser browser = new Browser(PATIENCE)) {
            play(browser, port);
        } finally {
            server.descendants().forEach(ProcessHandle::destroy);
            server.destroy();
        }
    }

    private static Optional<Path> codeServer() {
        return Optional.ofNullable(System.getenv(VARIABLE))
                .map(each -> Path.of(each, "node_modules/code-server/out/node/entry.js"))
                .filter(Files::exists);
    }

    private void run(Path directory, String... command) throws Exception {
        Path said = folder.resolve("said.txt");
        ProcessBuilder process =
                new ProcessBuilder(command)
                        .directory(directory.toAbsolutePath().toFile())
                        .redirectErrorStream(true);
        int status = process.redirectOutput(said.toFile()).start().waitFor();
        assertThat(status).as(Files.readString(said)).isZero();
    }

    private static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0)) {
            return socket.getLocalPort();
        }
    }

    private Process start(Path codeServer, int port) throws Exception {
        Map<String, Object> settings =
                Map.of(
                        "arcomat.path", COMMAND,
                        "workbench.startupEditor", "none",
                        "workbench.colorTheme", "Default Light Modern",
                        "extensions.ignoreRecommendations", true,
                        "telemetry.telemetryLevel", "off");
        Path user = Files.createDirectories(folder.resolve("user/User"));
        new ObjectMapper().writeValue(user.resolve("settings.json").toFile(), settings);
        List<String> own =
                List.of(
                        "node",
                        codeServer.toString(),
                        "--config",
                        Files.writeString(folder.resolve("config.yaml"), "auth: none\n").toString(),
                        "--user-data-dir",
                        folder.resolve("user").toString(),
                        "--extensions-dir",
                        folder.resolve("extensions").toString());
        run(
                folder,
                with(own, "--install-extension", folder.resolve("arcomat-0.0.1.vsix").toString()));
        return new ProcessBuilder(
                        with(
                                own,
                                "--bind-addr",
                                "127.0.0.1:" + port,
                                "--disable-telemetry",
                                "--disable-update-check",
                                "--disable-workspace-trust"))
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("server.txt").toFile())
                .start();
    }

    private static String[] with(List<String> words, String... more) {
        return Stream.concat(words.stream(), Arrays.stream(more)).toArray(String[]::new);
    }

    private void play(Browser browser, int port) throws IOException {
        String address = "http://127.0.0.1:%d/?folder=%s".formatted(port, folder.resolve("models"));
        browser.await(() -> isListening(port));
        browser.open(address, ".monaco-workbench .explorer-viewlet .monaco-list-row");
        WorkbenchScript script = new WorkbenchScript(browser);
        for (String line : Files.readAllLines(SCRIPT)) {
            if (!line.isBlank() && !line.startsWith("#")) {
                script.run(line);
            }
        }
    }

    private static boolean isListening(int port) {
        try (var socket = new Socket("127.0.0.1", port)) {
            return socket.isConnected();
        } catch (IOException notYet) {
            return false;
        }
    }
}
