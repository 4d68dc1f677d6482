package arcomat.analysis;

import arcomat.model.Model;
import arcomat.models.ModelFiles;
import arcomat.models.ReadModels;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.DynamicTest;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * A data file of the tests of analyses: {@code == models FOLDER} and {@code == file PATH} bring
 * models, any other {@code == kind rest} is a question about them. Lines with a number sign are
 * comments.
 */
public record Sections(List<Section> all) {

    /**
     * @param lines without empty lines and comments, but for a file
     */
    public record Section(String kind, String rest, List<String> lines) {}

    public static Sections read(Path file) {
        try {
            return parse(Files.readAllLines(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Sections parse(List<String> lines) {
        List<Section> sections = new ArrayList<>();
        for (String line : lines) {
            if (line.startsWith("== ")) {
                String[] words = line.split(" ", 3);
                sections.add(new Section(words[1], words[2], new ArrayList<>()));
            } else if (!sections.isEmpty()) {
                Section last = sections.get(sections.size() - 1);
                boolean text = last.kind.equals("file");
                if (text || !line.isBlank() && !line.startsWith("#")) {
                    last.lines.add(line);
                }
            }
        }
        return new Sections(sections);
    }

    public List<Section> of(String kind) {
        return all.stream().filter(section -> section.kind.equals(kind)).toList();
    }

    /** A test for each question of some kinds, named by what is asked and what is said first. */
    public Stream<DynamicTest> tests(Set<String> kinds, Consumer<Section> check) {
        return all.stream()
                .filter(section -> kinds.contains(section.kind))
                .map(
                        section ->
                                DynamicTest.dynamicTest(
                                        section.rest + ": " + section.lines.get(0),
                                        () -> check.accept(section)));
    }

    /** The models as files. */
    public List<SourceFile> sources() {
        List<SourceFile> sources = new ArrayList<>();
        of("models").forEach(folder -> sources.addAll(ModelFiles.of(Path.of(folder.rest))));
        of("file")
                .forEach(
                        f ->
                                sources.add(
                                        new SourceFile(f.rest, String.join("\n", f.lines) + "\n")));
        return sources;
    }

    public Model model() {
        return ReadModels.model(sources());
    }
}
