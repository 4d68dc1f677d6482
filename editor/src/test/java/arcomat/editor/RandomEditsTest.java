package arcomat.editor;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.editor.answer.CanonicalLayout;
import arcomat.editor.answer.Fixes;
import arcomat.editor.answer.GoTo;
import arcomat.editor.answer.NamedPlaces;
import arcomat.editor.answer.completion.Completion;
import arcomat.editor.answer.fact.HoverCard;
import arcomat.editor.answer.fact.InlineFacts;
import arcomat.editor.answer.fact.ParameterHelp;
import arcomat.editor.answer.shape.DocumentOutline;
import arcomat.editor.answer.shape.Folds;
import arcomat.editor.answer.shape.NameColours;
import arcomat.editor.answer.shape.Selections;
import arcomat.editor.desk.Desk;
import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Whatever somebody types, there are answers, and they are those of whoever opens the texts as they
 * are then; after everything is undone, they are those of the beginning and of {@code arcomat
 * check}.
 */
class RandomEditsTest {
    /**
     * How many edits lie between two comparisons with somebody who sees the texts for the first.
     */
    private static final int BETWEEN_COMPARISONS = 40;

    private static final CodeActionContext NO_FINDING = new CodeActionContext(List.of());

    private static final List<String> WORDS =
            List.of(
                    " ",
                    "\n",
                    ";",
                    "{",
                    "}",
                    "(",
                    "\"",
                    "/*",
                    "component ",
                    "port in ",
                    "connect ",
                    "automaton {",
                    "->",
                    "refines ",
                    "extends ",
                    "import ",
                    "Integer ",
                    "state ",
                    "<<suppress = \"ARC0110: x\">> ",
                    "test t {",
                    "\u00e4",
                    "\ud83d\ude00",
                    "\r\n");

    @TempDir private Path temporary;

    private final Desk desk = new Desk();
    private final Map<Path, String> texts = new TreeMap<>();
    private final Deque<Undo> undos = new ArrayDeque<>();

    private record Undo(Path file, Range range, String text) {}

    @Tag("slow")
    @Test
    void aThousand() throws IOException, WrongUse {
        editAndUndo(1_000, new Random(2));
    }

    private void editAndUndo(int edits, Random random) throws IOException, WrongUse {
        copyModels();
        desk.add(temporary);
        texts.forEach(desk::open);
        Set<String> before = checked(desk);
        assertThat(before).isEqualTo(byCommand());
        for (int i = 0; i < edits; i++) {
            edit(random);
            ask(random);
            if (i % BETWEEN_COMPARISONS == 0) {
                assertThat(checked(desk)).as("edit " + i).isEqualTo(checked(fresh()));
            }
        }
        while (!undos.isEmpty()) {
            Undo undo = undos.pop();
            change(undo.file(), undo.range(), undo.text());
        }
        assertThat(checked(desk)).isEqualTo(before).isEqualTo(checked(fresh()));
    }

    private void copyModels() throws IOException {
        Path from = Path.of("models/coffee/coffee");
        temporary = temporary.toRealPath();
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : files.filter(RandomEditsTest::isModel).toList()) {
                Path to = temporary.resolve("coffee").resolve(from.relativize(file).toString());
                Files.createDirectories(to.getParent());
                Files.copy(file, to);
                texts.put(to, Files.readString(to));
            }
        }
    }

    private static boolean isModel(Path file) {
        return Stream.of(".arc", ".cd", ".mt").anyMatch(file.toString()::endsWith);
    }

    private Desk fresh() {
        Desk fresh = new Desk();
        fresh.add(temporary);
        texts.forEach(fresh::open);
        return fresh;
    }

    private static Set<String> checked(Desk desk) {
        desk.check(() -> {});
        Set<String> findings = new TreeSet<>();
        for (OpenModels models : desk.models()) {
            for (String path : models.checkedPaths()) {
                models.findings(path).forEach(each -> findings.add(text(each)));
            }
        }
        return findings;
    }

    private static String text(Diagnostic finding) {
        return finding.span()
                + "-"
                + finding.span().end()
                + " "
                + finding.code()
                + " "
                + finding.message();
    }

    private Set<String> byCommand() throws WrongUse {
        var result = Session.in(temporary, Progress.NONE).run(new CheckFiles(List.of("."), false));
        return result.findings().stream()
                .map(RandomEditsTest::text)
                .collect(Collectors.toCollection(TreeSet::new));
    }

    /** Types, deletes, pastes from elsewhere, or takes back. */
    private void edit(Random random) {
        if (random.nextInt(3) == 0 && !undos.isEmpty()) {
            Undo undo = undos.pop();
            change(undo.file(), undo.range(), undo.text());
            return;
        }
        List<Path> files = List.copyOf(texts.keySet());
        Path file = files.get(random.nextInt(files.size()));
        String text = text(file);
        int start = random.nextInt(text.length() + 1);
        int end = Math.min(text.length(), start + random.nextInt(4) * random.nextInt(20));
        String fresh = random.nextBoolean() ? word(random) : piece(files, random);
        SourceFile before = new SourceFile("", text);
        Range range = new Range(Positions.position(before, start), Positions.position(before, end));
        // What a line break made of two letters is cut into is another place.
        int from = Positions.offset(before, range.getStart());
        int to = Math.max(from, Positions.offset(before, range.getEnd()));
        SourceFile after = new SourceFile("", text.substring(0, from) + fresh + text.substring(to));
        Range written =
                new Range(range.getStart(), Positions.position(after, from + fresh.length()));
        boolean canBeTakenBack =
                Positions.offset(after, written.getStart()) == from
                        && Positions.offset(after, written.getEnd()) == from + fresh.length();
        if (canBeTakenBack) {
            undos.push(new Undo(file, written, text.substring(from, to)));
            change(file, range, fresh);
        }
    }

    private String text(Path file) {
        return texts.get(file);
    }

    private static String word(Random random) {
        return WORDS.get(random.nextInt(WORDS.size()));
    }

    private String piece(List<Path> files, Random random) {
        String text = text(files.get(random.nextInt(files.size())));
        int start = random.nextInt(text.length() + 1);
        return text.substring(start, Math.min(text.length(), start + random.nextInt(60)));
    }

    private void change(Path file, Range range, String text) {
        desk.change(file, List.of(new TextDocumentContentChangeEvent(range, text)));
        String after = desk.onScreen(file).orElseThrow().text();
        texts.put(file, after);
    }

    /** What editors ask after a key, and now and then the rest. */
    private void ask(Random random) {
        Path file = undos.isEmpty() ? texts.keySet().iterator().next() : undos.peek().file();
        Optional<View> view = desk.view(file);
        if (view.isPresent()) {
            ask(view.get(), random);
        }
    }

    private static void ask(View view, Random random) {
        int offset = random.nextInt(view.file().text().length() + 1);
        Position position = Positions.position(view.file(), offset);
        assertThat(Completion.at(view, offset)).doesNotContainNull();
        assertThat(GoTo.definition(view, position)).doesNotContainNull();
        assertThat(NamedPlaces.references(view, position, true)).doesNotContainNull();
        assertThat(Fixes.at(view, Positions.all(view.file()), NO_FINDING)).doesNotContainNull();
        assertThat(CanonicalLayout.of(view)).doesNotContainNull();
        assertThat(HoverCard.at(view, position)).isNotNull();
        assertThat(ParameterHelp.at(view, offset)).isNotNull();
        assertThat(InlineFacts.in(view, Positions.all(view.file()))).doesNotContainNull();
        assertThat(DocumentOutline.of(view)).doesNotContainNull();
        assertThat(Folds.of(view)).doesNotContainNull();
        assertThat(Selections.at(view, List.of(position))).hasSize(1);
        assertThat(NameColours.of(view).getData()).isNotNull();
    }
}
