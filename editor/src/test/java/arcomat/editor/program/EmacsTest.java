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
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Emacs without a screen, with Eglot and the lines that {@code docs/editors.md} has for it, and the
 * installed command: {@code emacs/drive.el} does with a model what {@link KateClientTest} has done.
 */
@Tag("editor")
class EmacsTest {
    private static final Path DRIVE = Path.of("editor/src/test/resources/emacs/drive.el");
    private static final Path PAGE = Path.of("docs/editors.md");
    private static final Pattern LISP = Pattern.compile("(?s)```lisp\n(.*?)```");
    private static final long MINUTES = 4;

    @TempDir private Path folder;

    @Test
    void aModelIsMendedLaidOutAndRenamed() throws Exception {
        assumeTrue(hasEglot(), "Emacs with Eglot is not installed");
        MisspelledDoor models = MisspelledDoor.in(folder.resolve("models"));
        Matcher lines = LISP.matcher(Files.readString(PAGE));
        assertThat(lines.find()).isTrue();
        Path init = Files.writeString(folder.resolve("init.el"), lines.group(1));
        Path output = folder.resolve("output.txt");
        Process emacs =
                emacs(output, "-l", init.toString(), "-l", DRIVE.toAbsolutePath().toString());
        boolean ended = emacs.waitFor(MINUTES, TimeUnit.MINUTES);
        emacs.destroy();
        assertThat(ended).as(Files.readString(output)).isTrue();
        assertThat(emacs.exitValue()).as(Files.readString(output)).isZero();
        models.isMendedLaidOutAndRenamed();
    }

    private boolean hasEglot() throws Exception {
        if (!Installed.isThere("emacs")) {
            return false;
        }
        Files.createDirectories(folder.resolve("models"));
        Process emacs = emacs(folder.resolve("asked.txt"), "--eval", "(require 'eglot)");
        return emacs.waitFor(MINUTES, TimeUnit.MINUTES) && emacs.exitValue() == 0;
    }

    private Process emacs(Path output, String... arguments) throws IOException {
        ProcessBuilder emacs = new ProcessBuilder("emacs", "-q", "--batch");
        emacs.command().addAll(List.of(arguments));
        Path installed = Path.of("build/install/arcomat/bin").toAbsolutePath();
        emacs.environment().put("PATH", installed + File.pathSeparator + System.getenv("PATH"));
        emacs.environment().put("HOME", folder.toString());
        Path yes = Files.writeString(folder.resolve("yes.txt"), "y\n");
        return emacs.directory(folder.resolve("models").toFile())
                .redirectErrorStream(true)
                .redirectOutput(output.toFile())
                .redirectInput(yes.toFile())
                .start();
    }
}
