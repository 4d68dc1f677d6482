package arcomat.editor.extension;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/**
 * Packs the extension as {@code ./gradlew packVsCode} does: its code compiles, its colours are
 * those that the files of {@code test/grammar} expect, and the archive has what VS Code looks for.
 */
@Tag("editor")
class PackedExtensionTest {
    private static final String PACK = "editors/vscode/pack";
    private static final Pattern PATH = Pattern.compile("\"\\./([^\"]+)\"");

    /** What the script says where the programs that it needs are not here. */
    private static final Pattern MISSING =
            Pattern.compile("no extension for VS Code is packed: npm.*(path|reached).*\\R");

    @TempDir private Path folder;

    @Test
    void theArchiveHasWhatTheManifestNames() throws Exception {
        Path output = folder.resolve("said.txt");
        Process packing = pack(output, Path.of("packed").toString());
        String said = Files.readString(output);
        assumeFalse(MISSING.matcher(said).matches(), said.strip());
        assertThat(packing.exitValue()).as(said).isZero();
        try (ZipFile archive = new ZipFile(folder.resolve("packed/arcomat-1.2.3.vsix").toFile())) {
            JsonNode manifest = manifest(archive);
            assertThat(manifest.get("version").textValue()).isEqualTo("1.2.3");
            assertThat(entries(archive)).containsAll(wanted(manifest));
            assertThat(entries(archive))
                    .noneMatch(each -> each.matches("extension/(src|test)/.*|.*\\.ts|.*npmrc"));
        }
    }

    @Test
    void whatIsMissingIsSaidInALine() throws Exception {
        Path output = folder.resolve("said.txt");
        ProcessBuilder packing = packing(output, folder.toString());
        packing.environment().put("PATH", "/usr/sbin");
        assertThat(packing.start().waitFor()).isEqualTo(1);
        assertThat(Files.readString(output)).matches(MISSING);
    }

    private Process pack(Path output, String into) throws Exception {
        Process packing = packing(output, folder.resolve(into).toString()).start();
        packing.waitFor();
        return packing;
    }

    private static ProcessBuilder packing(Path output, String into) {
        File said = output.toFile();
        return new ProcessBuilder("/bin/bash", PACK, into, "1.2.3")
                .redirectErrorStream(true)
                .redirectOutput(said);
    }

    private static JsonNode manifest(ZipFile archive) throws IOException {
        ZipEntry entry = archive.getEntry("extension/package.json");
        try (InputStream in = archive.getInputStream(entry)) {
            return new ObjectMapper().readTree(in);
        }
    }

    private static Set<String> entries(ZipFile archive) {
        Set<String> names = new TreeSet<>();
        archive.stream().forEach(entry -> names.add(entry.getName()));
        return names;
    }

    /** All files that the manifest names, the library that it needs, and what pages are made of. */
    private static Set<String> wanted(JsonNode manifest) {
        Set<String> wanted = new TreeSet<>();
        PATH.matcher(manifest.toString())
                .results()
                .forEach(path -> wanted.add("extension/" + path.group(1)));
        manifest.get("contributes")
                .findValuesAsText("markdown")
                .forEach(path -> wanted.add("extension/" + path));
        wanted.addAll(
                List.of(
                        "extension/LICENSE.txt",
                        "extension/view/diagram.css",
                        "extension/view/clicks.js",
                        "extension/view/cursor.js",
                        "extension/node_modules/vscode-languageclient/node.js"));
        return wanted;
    }
}
