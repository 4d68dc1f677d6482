package arcomat.pipeline.recheck;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.guest.host.Guests;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What is said of a file before the others have been read is said of it afterwards, too. */
class FirstLookTest {
    private static final Path ROOT = Path.of("models/coffee").toAbsolutePath();
    private static final Pattern WORD = Pattern.compile("[A-Za-z]\\w*");
    private static final int EDITS = 4;

    @Tag("slow")
    @Test
    void saysNothingThatIsTakenBack() throws IOException {
        Random random = new Random(16);
        OpenModels all = all();
        int found = 0;
        for (String path : List.copyOf(all.paths())) {
            for (int i = 0; i < EDITS && !all.isLibrary(path); i++) {
                SourceFile edited = edited(all.source(path).orElseThrow(), random);
                OpenModels after = all.with(OpenModels.Edit.of(List.of(edited))).check(() -> {});
                List<String> first =
                        FirstLook.at(ROOT, edited, Guests.NONE, LibraryModels.NONE)
                                .map(FirstLook::findings)
                                .stream()
                                .flatMap(List::stream)
                                .map(FirstLookTest::text)
                                .toList();
                assertThat(after.findings(path).stream().map(FirstLookTest::text))
                        .as(edited.text())
                        .containsAll(first);
                found += first.size();
            }
        }
        assertThat(found).isGreaterThan(EDITS * all.paths().size() / 2);
    }

    private static OpenModels all() throws IOException {
        List<SourceFile> texts = new ArrayList<>();
        try (Stream<Path> files = Files.walk(ROOT.resolve("coffee"))) {
            for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
                if (Stream.of(".arc", ".cd", ".mt").anyMatch(file.toString()::endsWith)) {
                    String path = ROOT.relativize(file).toString();
                    texts.add(new SourceFile(path, Files.readString(file)));
                }
            }
        }
        return OpenModels.in(ROOT, false).with(OpenModels.Edit.of(texts)).check(() -> {});
    }

    /** Some word becomes another one; a letter may be lost. The package stays. */
    private static SourceFile edited(SourceFile file, Random random) {
        String text = file.text();
        int begin = text.indexOf(';') + 1;
        List<MatchResult> words =
                WORD.matcher(text).results().filter(each -> each.start() > begin).toList();
        MatchResult word = words.get(random.nextInt(words.size()));
        String other =
                random.nextInt(3) == 0 ? "" : words.get(random.nextInt(words.size())).group();
        return new SourceFile(
                file.path(), text.substring(0, word.start()) + other + text.substring(word.end()));
    }

    /** What is guessed to be meant may be another name, once all names are known. */
    private static String text(Diagnostic finding) {
        return finding.span() + "-" + finding.span().end() + " " + finding.code();
    }
}
