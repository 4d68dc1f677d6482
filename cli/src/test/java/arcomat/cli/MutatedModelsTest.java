package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.terminal.ExitStatus;
import arcomat.report.finding.SarifSchema;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.lifecycle.AfterContainer;
import net.jqwik.api.lifecycle.BeforeContainer;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

import javax.xml.parsers.DocumentBuilderFactory;

/** Good models with something changed in one file: no command ever fails by itself. */
class MutatedModelsTest {
    private static final Path MODELS = Path.of("models/coffee");

    private static Path directory;
    private static Path reports;
    private static List<Path> files;

    @BeforeContainer
    static void copyModels() throws IOException {
        directory = Files.createTempDirectory("arcomat-mutated");
        reports = Files.createTempDirectory("arcomat-reports");
        try (Stream<Path> paths = Files.walk(MODELS)) {
            files =
                    paths.filter(p -> p.toString().matches(".*\\.(arc|cd|mt)"))
                            .map(MODELS::relativize)
                            .sorted()
                            .toList();
        }
        for (Path file : files) {
            Files.createDirectories(directory.resolve(file).getParent());
            Files.copy(MODELS.resolve(file), directory.resolve(file));
        }
    }

    @AfterContainer
    static void removeModels() throws IOException {
        Folders.delete(directory);
        Folders.delete(reports);
    }

    @Tag("slow")
    @Property(seed = "1", tries = 25)
    void aPieceIsMissing(
            @ForAll int file, @ForAll int start, @ForAll @IntRange(max = 40) int length)
            throws Exception {
        mutate(file, start, length, new byte[0]);
    }

    @Tag("slow")
    @Property(seed = "2", tries = 20)
    void aPieceIsInserted(
            @ForAll int file, @ForAll int start, @ForAll @IntRange(max = 24) int token)
            throws Exception {
        String[] tokens = {
            "{",
            "}",
            "(",
            ")",
            "[",
            "]",
            "<",
            ">",
            "<<",
            ">>",
            ";",
            ",",
            "->",
            "--",
            "==",
            "\"",
            "'",
            "/*",
            "component",
            "automaton",
            "port",
            "in",
            "9999999999999999999",
            "\u0000",
            "ü"
        };
        mutate(file, start, 0, tokens[token].getBytes(StandardCharsets.UTF_8));
    }

    @Tag("slow")
    @Property(seed = "3", tries = 20)
    void theFileIsCut(@ForAll int file, @ForAll int start) throws Exception {
        mutate(file, start, Integer.MAX_VALUE, new byte[0]);
    }

    private static void mutate(int chosen, int start, int length, byte[] inserted)
            throws Exception {
        Path file = directory.resolve(files.get(Math.floorMod(chosen, files.size())));
        byte[] good = Files.readAllBytes(file);
        int from = Math.floorMod(start, good.length + 1);
        int to = (int) Math.min(good.length, (long) from + length);
        byte[] bad = new byte[from + inserted.length + good.length - to];
        System.arraycopy(good, 0, bad, 0, from);
        System.arraycopy(inserted, 0, bad, from, inserted.length);
        System.arraycopy(good, to, bad, from + inserted.length, good.length - to);
        try {
            Files.write(file, bad);
            checkReports();
            runsWithoutInternalError("format", "--check", file.toString());
        } finally {
            Files.write(file, good);
        }
    }

    /** Whatever is wrong with the models, reports about it are in order. */
    private static void checkReports() throws Exception {
        Path sarif = reports.resolve("check.sarif");
        Path junit = reports.resolve("check.xml");
        runsWithoutInternalError(
                "check", "--report", "sarif=" + sarif, "--report", "junit=" + junit, ".");
        assertThat(SarifSchema.problems(Files.readString(sarif))).isEmpty();
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(junit.toFile());
    }

    private static void runsWithoutInternalError(String... arguments) throws Exception {
        StringWriter err = new StringWriter();
        PrintWriter out = new PrintWriter(Writer.nullWriter());
        int status = Embedded.run(directory, out, new PrintWriter(err), arguments);
        assertThat(err.toString()).isEmpty();
        assertThat(status).isBetween(ExitStatus.FINE, ExitStatus.WRONG_USE);
    }
}
