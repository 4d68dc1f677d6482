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

/**
 * Neovim with the lines that {@code docs/editors.md} has for it, and the installed command: a model
 * is opened, broken, mended, renamed and formatted by {@code neovim/drive.lua}, which tells what is
 * then to be seen.
 */
@Tag("editor")
class NeovimTest {
    private static final Path FILES = Path.of("editor/src/test/resources/neovim");
    private static final Path PAGE = Path.of("docs/editors.md");
    private static final Pattern LUA = Pattern.compile("(?s)```lua\n(.*?)```");
    private static final long MINUTES = 4;

    @TempDir private Path folder;

    @Test
    void aModelIsBrokenMendedRenamedAndFormatted() throws Exception {
        assumeTrue(Installed.isThere("nvim"), "Neovim (nvim) is not installed");
        Path models = Files.createDirectories(folder.resolve("models/p"));
        for (String name : new String[] {"Door.arc", "House.arc"}) {
            Files.copy(FILES.resolve("p").resolve(name), models.resolve(name));
        }
        Files.writeString(folder.resolve("init.lua"), linesOfThePage());
        Path told = folder.resolve("told.txt");
        Path output = folder.resolve("output.txt");
        Process neovim = start(told, output);
        boolean ended = neovim.waitFor(MINUTES, TimeUnit.MINUTES);
        neovim.destroyForcibly();
        assertThat(ended).as(Files.readString(output)).isTrue();
        assertThat(told)
                .as(Files.readString(output))
                .hasSameTextualContentAs(FILES.resolve("told.txt"));
    }

    private static String linesOfThePage() throws IOException {
        Matcher lua = LUA.matcher(Files.readString(PAGE));
        assertThat(lua.find()).isTrue();
        return lua.group(1);
    }

    private Process start(Path told, Path output) throws IOException {
        ProcessBuilder neovim =
                new ProcessBuilder(
                        "nvim",
                        "--headless",
                        "-n",
                        "-i",
                        "NONE",
                        "-u",
                        folder.resolve("init.lua").toString(),
                        "-S",
                        FILES.resolve("drive.lua").toAbsolutePath().toString(),
                        "p/Door.arc");
        Path installed = Path.of("build/install/arcomat/bin").toAbsolutePath();
        neovim.environment()
                .putAll(
                        Map.of(
                                "PATH", installed + File.pathSeparator + System.getenv("PATH"),
                                "TOLD", told.toString(),
                                "XDG_CONFIG_HOME", folder.resolve("config").toString(),
                                "XDG_DATA_HOME", folder.resolve("data").toString(),
                                "XDG_CACHE_HOME", folder.resolve("cache").toString(),
                                "XDG_STATE_HOME", folder.resolve("state").toString()));
        return neovim.directory(folder.resolve("models").toFile())
                .redirectErrorStream(true)
                .redirectOutput(output.toFile())
                .redirectInput(ProcessBuilder.Redirect.from(new File("/dev/null")))
                .start();
    }
}
