package arcomat.editor;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.editor.desk.Desk;
import arcomat.pipeline.recheck.FirstLook;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Who opens a file sees what is wrong with it before all others are known. */
class FirstFindingsTest {
    private static final String WHOLE =
            """
            package p;

            component Whole {
                port in Boolean on;
                component Part part;
                connect on -> part.off;
            }
            """;

    /** More files than are taken over in one step. */
    private static final int MANY = 100;

    @TempDir private Path folder;
    private final Desk desk = new Desk();

    @BeforeEach
    void write() throws IOException {
        folder = folder.toRealPath();
        Files.createDirectory(folder.resolve("p"));
        Files.writeString(place("Whole"), WHOLE);
        Files.writeString(
                place("Part"), "package p;\n\ncomponent Part {\n    port in Boolean on;\n}\n");
        Files.writeString(
                place("Other"), "package p;\n\ncomponent Another {\n    port in Boolean on;\n}\n");
        desk.add(folder);
        desk.open(place("Whole"), WHOLE);
    }

    private Path place(String name) {
        return folder.resolve("p").resolve(name + ".arc");
    }

    @Test
    void ofAFileThatIsOpenedBeforeTheOthersAreRead() {
        Optional<FirstLook> look = desk.firstLook(place("Whole"));
        assertThat(look.map(each -> each.models().paths()).orElseThrow())
                .containsExactly("p/Part.arc", "p/Whole.arc");
        assertThat(codes(look.orElseThrow().findings())).containsExactly("ARC0103");
        desk.check(() -> {});
        assertThat(desk.firstLook(place("Whole"))).isEmpty();
        assertThat(codes(models().findings("p/Whole.arc"))).containsExactly("ARC0103");
    }

    @Test
    void ofWhatIsOnTheScreenBeforeTheRest() {
        desk.checkScreen(() -> {});
        assertThat(codes(models().findings("p/Whole.arc"))).containsExactly("ARC0103");
        assertThat(models().due()).containsExactlyInAnyOrder("p/Part.arc", "p/Other.arc");
        assertThat(desk.checkSome(() -> {})).isTrue();
        assertThat(desk.checkSome(() -> {})).isFalse();
        assertThat(models().due()).isEmpty();
        assertThat(codes(models().findings("p/Other.arc"))).containsExactly("ARC0207");
    }

    @Test
    void ofAFileThatIsOpenedWhileTheOthersAreRead() throws IOException {
        for (int i = 0; i < MANY; i++) {
            Files.writeString(place("Other" + i), "package p;\n\ncomponent Other" + i + " {}\n");
        }
        Desk late = new Desk();
        late.add(folder);
        assertThat(late.readSome()).isTrue();
        late.open(place("Whole"), WHOLE);
        assertThat(late.firstLook(place("Whole"))).isPresent();
        assertThat(late.readSome()).isTrue();
        assertThat(late.firstLook(place("Whole"))).isPresent();
        late.checkScreen(() -> {});
        assertThat(late.readSome()).isFalse();
        OpenModels all = late.models().iterator().next();
        assertThat(all.paths()).hasSize(MANY + 3);
        assertThat(codes(all.findings("p/Whole.arc"))).containsExactly("ARC0103");
    }

    @Test
    void knowsModelsOfOthers() throws IOException {
        Path own = Files.createDirectories(folder.resolve("own/q")).resolve("Robot.arc");
        String text =
                "package q;\n\nimport p.*;\n\ncomponent Robot {\n    component Part part;\n}\n";
        Files.writeString(own, text);
        Desk fresh = new Desk();
        fresh.add(folder.resolve("own"));
        fresh.open(own, text);
        assertThat(codes(fresh.firstLook(own).orElseThrow().findings())).contains("ARC0121");
        assertThat(fresh.referTo(List.of(folder))).isEmpty();
        assertThat(codes(fresh.firstLook(own).orElseThrow().findings())).doesNotContain("ARC0121");
    }

    /** Those without a package come first by their names, and last to their root. */
    @Test
    void filesComeToTheRootToWhichTheyComeAllAtOnce() throws IOException {
        Path beside = Files.createDirectory(folder.resolve("beside"));
        for (int i = 0; i < MANY; i++) {
            Files.writeString(beside.resolve("Free" + i + ".arc"), "component Free" + i + " {}\n");
        }
        Desk fresh = new Desk();
        fresh.add(folder);
        assertThat(fresh.models()).extracting(OpenModels::root).containsExactly(folder);
    }

    private OpenModels models() {
        return desk.models().iterator().next();
    }

    private static List<String> codes(List<Diagnostic> findings) {
        return findings.stream().filter(Diagnostic::isError).map(Diagnostic::code).toList();
    }
}
