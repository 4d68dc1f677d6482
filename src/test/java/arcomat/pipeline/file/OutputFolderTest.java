package arcomat.pipeline.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import static java.nio.charset.StandardCharsets.UTF_8;

import arcomat.pipeline.WrongUse;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

class OutputFolderTest {
    /** The number of a process that cannot be alive. */
    private static final long DEAD = 9_999_999_999L;

    @TempDir private Path temporary;

    private void replace(Map<String, String> files) throws WrongUse {
        Map<String, byte[]> contents = new LinkedHashMap<>();
        files.forEach((path, text) -> contents.put(path, text.getBytes(UTF_8)));
        OutputFolder.replace(temporary.resolve("out"), "out", contents);
    }

    private List<String> content() throws IOException {
        try (Stream<Path> paths = Files.walk(temporary)) {
            return paths.filter(Files::isRegularFile)
                    .map(p -> temporary.relativize(p).toString())
                    .sorted()
                    .toList();
        }
    }

    @Test
    void writesFilesAndTheirList() throws Exception {
        replace(Map.of("p/A.java", "class A {}", "B.java", "class B {}"));
        assertThat(content())
                .containsExactly("out/.arcomat-generated", "out/B.java", "out/p/A.java");
        assertThat(temporary.resolve("out/.arcomat-generated")).hasContent("B.java\np/A.java\n");
    }

    @Test
    void removesItsOwnFilesThatAreNoLongerGenerated() throws Exception {
        replace(Map.of("p/A.java", "1", "q/B.java", "1"));
        replace(Map.of("p/A.java", "2"));
        assertThat(content()).containsExactly("out/.arcomat-generated", "out/p/A.java");
        assertThat(temporary.resolve("out/p/A.java")).hasContent("2");
    }

    @Test
    void takesAnEmptyFolder() throws Exception {
        Files.createDirectories(temporary.resolve("out/empty"));
        replace(Map.of("A.java", "1"));
        assertThat(content()).containsExactly("out/.arcomat-generated", "out/A.java");
    }

    @Test
    void refusesFilesOfOthersAndKeepsEverything() throws Exception {
        replace(Map.of("A.java", "1"));
        Files.writeString(temporary.resolve("out/thesis.txt"), "all my work");
        assertThatThrownBy(() -> replace(Map.of("A.java", "2")))
                .isInstanceOf(WrongUse.class)
                .hasMessageContaining(
                        "'out' holds files that arcomat did not generate: thesis.txt");
        assertThat(content())
                .containsExactly("out/.arcomat-generated", "out/A.java", "out/thesis.txt");
        assertThat(temporary.resolve("out/A.java")).hasContent("1");
    }

    @Test
    void refusesAPathThatLeavesTheFolderBeforeWritingAnything() throws IOException {
        for (String path : List.of("../A.java", "/A.java", "p/../../A.java", ".")) {
            assertThatThrownBy(() -> replace(Map.of("B.java", "1", path, "2")))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("leaves the output folder");
        }
        assertThat(content()).isEmpty();
    }

    @Test
    void refusesAFileInPlaceOfTheFolder() throws Exception {
        Files.writeString(temporary.resolve("out"), "text");
        assertThatThrownBy(() -> replace(Map.of("A.java", "1")))
                .isInstanceOf(WrongUse.class)
                .hasMessage("'out' is a file; --out names a folder");
    }

    @Test
    void saysThatItCannotWrite() throws Exception {
        Files.writeString(temporary.resolve("file"), "text");
        assertThatThrownBy(
                        () ->
                                OutputFolder.replace(
                                        temporary.resolve("file/out"),
                                        "file/out",
                                        Map.of("A.java", new byte[] {1})))
                .isInstanceOf(WrongUse.class)
                .hasMessageStartingWith("cannot write to 'file/out': ");
    }

    @Test
    void leavesNothingHalfWrittenWhenAFileCannotBeWritten() throws Exception {
        replace(Map.of("A.java", "1"));
        // One path needs a folder where another one has put a file.
        Map<String, String> impossible = new LinkedHashMap<>();
        impossible.put("p", "a file");
        impossible.put("p/A.java", "2");
        assertThatThrownBy(() -> replace(impossible)).isInstanceOf(WrongUse.class);
        assertThat(content()).containsExactly("out/.arcomat-generated", "out/A.java");
        assertThat(temporary.resolve("out/A.java")).hasContent("1");
    }

    @Test
    void repairsARunThatWasKilledBetweenTheTwoMoves() throws Exception {
        replace(Map.of("A.java", "1"));
        Files.move(temporary.resolve("out"), temporary.resolve(".out.arcomat-old-" + DEAD));
        Files.createDirectories(temporary.resolve(".out.arcomat-new-" + DEAD + "/p"));
        replace(Map.of("B.java", "2"));
        assertThat(content()).containsExactly("out/.arcomat-generated", "out/B.java");
        try (Stream<Path> left = Files.list(temporary)) {
            assertThat(left).containsExactly(temporary.resolve("out"));
        }
    }

    /** Somebody else is writing, or moving, at the same time. */
    @Test
    void leavesTheFoldersOfLiveRunsAlone() throws Exception {
        long alive = ProcessHandle.current().parent().orElseThrow().pid();
        Path fresh = temporary.resolve(".out.arcomat-new-" + alive);
        Path retired = temporary.resolve(".out.arcomat-old-" + alive);
        Path other = temporary.resolve(".out.arcomat-new-backup");
        List<Path> theirs = List.of(fresh, other, retired);
        for (Path folder : theirs) {
            Files.createDirectories(folder);
            Files.writeString(folder.resolve("A.java"), "theirs");
        }
        replace(Map.of("A.java", "1"));
        replace(Map.of("A.java", "2"));
        assertThat(theirs).allSatisfy(each -> assertThat(each.resolve("A.java")).exists());
        assertThat(temporary.resolve("out/A.java")).hasContent("2");
    }
}
