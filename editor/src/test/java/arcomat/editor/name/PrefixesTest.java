package arcomat.editor.name;

import static org.assertj.core.api.Assertions.assertThatCode;

import arcomat.editor.answer.GoTo;
import arcomat.editor.answer.NamedPlaces;
import arcomat.editor.answer.Renames;
import arcomat.editor.desk.Desk;
import arcomat.editor.desk.OtherTexts;
import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;

import org.eclipse.lsp4j.Position;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Whoever types a model from its first letter on has an answer at each of them. */
class PrefixesTest {
    private static final Path ROOT = Path.of("models/coffee").toAbsolutePath();

    /** With parts, automata, types, tests. */
    private static final List<String> MODELS =
            List.of(
                    "coffee/fetcher/Fetcher.arc",
                    "coffee/fetcher/Drive.arc",
                    "coffee/fetcher/FetcherTest.mt",
                    "coffee/types/Types.cd");

    private static final int LETTERS_PER_STEP = 11;

    @Test
    void prefixesHaveAnswers() throws IOException {
        ask(LETTERS_PER_STEP);
    }

    @Test
    @Tag("slow")
    void everyPrefixHasAnswers() throws IOException {
        ask(1);
    }

    private void ask(int step) throws IOException {
        Desk desk = new Desk();
        desk.add(ROOT);
        for (String model : MODELS) {
            Path file = ROOT.resolve(model);
            String text = Files.readString(file);
            for (int end = 0; end <= text.length(); end += step) {
                desk.open(file, text.substring(0, end));
                ask(desk.view(file).orElseThrow());
            }
            desk.close(file);
        }
    }

    private void ask(View view) {
        int length = view.file().text().length();
        for (int offset : new int[] {length, length - 1, length / 2}) {
            Position at = Positions.position(view.file(), Math.max(0, offset));
            assertThatCode(() -> ask(view, at)).as(view.file().text()).doesNotThrowAnyException();
        }
    }

    private static void ask(View view, Position at) {
        GoTo.definition(view, at);
        GoTo.typeDefinition(view, at);
        GoTo.implementation(view, at);
        NamedPlaces.references(view, at, true);
        NamedPlaces.inFile(view, at);
        try {
            Renames.prepare(view, at);
            Renames.edit(view, at, "somethingElse", true, PrefixesTest::nothing, () -> {});
        } catch (RenameRefused refused) {
            // A reason is an answer.
        }
    }

    private static OtherTexts nothing() {
        return new OtherTexts(List.of(), name -> false);
    }
}
