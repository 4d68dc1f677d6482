package arcomat.editor.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Kate's client with the settings that {@code docs/editors.md} has for it, and the installed
 * command: {@code kate/drive.sh} opens a model that is misspelled and badly laid out, has it
 * mended, and renames a port of it, by keys on a screen that nobody sees.
 */
@Tag("editor")
class KateClientTest {
    private static final Path DRIVE = Path.of("editor/src/test/resources/kate/drive.sh");
    private static final Path COLOURS = Path.of("editors/kate");
    private static final Path PAGE = Path.of("docs/editors.md");
    private static final Pattern SETTINGS =
            Pattern.compile("(?s)```json\n(\\{\n  \"servers\".*?)```");
    private static final long MINUTES = 5;

    @TempDir private Path folder;

    @Test
    void aModelIsMendedLaidOutAndRenamed() throws Exception {
        assumeTrue(
                Stream.of("kate", "Xvfb", "xdotool").allMatch(Installed::isThere),
                "Kate, Xvfb and xdotool are not all installed");
        MisspelledDoor models = MisspelledDoor.in(folder.resolve("models"));
        configure();
        Path output = folder.resolve("output.txt");
        Process kate = start(output, models.door(), folder.resolve("said.txt"));
        boolean ended = kate.waitFor(MINUTES, TimeUnit.MINUTES);
        kate.descendants().forEach(ProcessHandle::destroy);
        kate.destroy();
        assertThat(ended).as(read(output)).isTrue();
        assertThat(kate.exitValue()).as(read(output)).isZero();
        models.isMendedLaidOutAndRenamed();
    }

    /** What somebody does once who has read the page; the last line says yes to the question. */
    private void configure() throws IOException {
        Matcher settings = SETTINGS.matcher(read(PAGE));
        assertThat(settings.find()).isTrue();
        write("config/kate/lspclient/settings.json", settings.group(1));
        try (Stream<Path> files = Files.list(COLOURS)) {
            for (Path file : files.toList()) {
                write("data/org.kde.syntax-highlighting/syntax/" + file.getFileName(), read(file));
            }
        }
        Path installed = Path.of("build/install/arcomat/bin/arcomat").toAbsolutePath();
        Path command =
                write(
                        "bin/arcomat",
                        "#!/bin/sh\nexec 9>'%2$s.lock'\nflock 9\n'%1$s' \"$@\" | tee '%2$s'\n"
                                .formatted(installed, folder.resolve("said.txt")));
        assertThat(command.toFile().setExecutable(true)).isTrue();
        write(
                "config/katerc",
                """
                [Kate Plugins]
                lspclientplugin=true

                [lspclient]
                AllowedServerCommandLines=%s language-server
                """
                        .formatted(command));
    }

    private Process start(Path output, Path door, Path said) throws IOException {
        Path drive = DRIVE.toAbsolutePath();
        ProcessBuilder kate =
                new ProcessBuilder("bash", drive.toString(), door.toString(), said.toString());
        Path own = Files.createDirectory(folder.resolve("runtime"));
        assertThat(own.toFile().setReadable(false, false)).isTrue();
        assertThat(own.toFile().setReadable(true, true)).isTrue();
        kate.environment()
                .putAll(
                        Map.of(
                                "PATH",
                                folder.resolve("bin") + File.pathSeparator + System.getenv("PATH"),
                                "HOME",
                                folder.toString(),
                                "XDG_CONFIG_HOME",
                                folder.resolve("config").toString(),
                                "XDG_DATA_HOME",
                                folder.resolve("data").toString(),
                                "XDG_CACHE_HOME",
                                folder.resolve("cache").toString(),
                                "XDG_RUNTIME_DIR",
                                own.toString(),
                                "QT_QPA_PLATFORM",
                                "xcb",
                                "DBUS_SESSION_BUS_ADDRESS",
                                "disabled:"));
        return kate.directory(folder.resolve("models").toFile())
                .redirectErrorStream(true)
                .redirectOutput(output.toFile())
                .redirectInput(ProcessBuilder.Redirect.from(new File("/dev/null")))
                .start();
    }

    private Path write(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    private static String read(Path file) throws IOException {
        return Files.readString(file);
    }
}
