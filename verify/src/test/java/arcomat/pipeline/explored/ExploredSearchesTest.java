package arcomat.pipeline.explored;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * A question that is asked in turns, each with more patience, goes on in the same files; what they
 * hold in the end is whole.
 */
class ExploredSearchesTest {
    private static final int CELLS = 10;

    /** So little that what is sorted is written in many files. */
    private static final long HEAP = 20_000;

    private static final Budget ALL =
            new Budget(() -> false, Long.MAX_VALUE).with(rule -> rule != Shortcut.SYMBOLIC);

    @TempDir private Path folder;

    private final Model model = ReadModels.model(file("Cell", CELL), file("Row", row()), ANY_FILE);
    private final Promise row = promise("Row");
    private final Promise any = promise("Any");

    private static final String CELL =
            """
            component Cell {
                port in Boolean x, out Boolean o;
                <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s {x == true} / {o = true};
                }
            }
            """;

    private static final SourceFile ANY_FILE =
            file(
                    "Any",
                    """
                    component Any {
                        port in Boolean x, out Boolean o;
                        <<completion = "output">> automaton {
                            state s;
                            initial s;
                        }
                    }
                    """);

    private static SourceFile file(String name, String text) {
        return new SourceFile("r/" + name + ".arc", "package r;\n" + text);
    }

    private static String row() {
        StringBuilder text =
                new StringBuilder("component Row {\nport in Boolean x, out Boolean o;\n");
        String before = "x";
        for (int cell = 0; cell < CELLS; cell++) {
            text.append(
                    "component Cell c%d;\nconnect %s -> c%d.x;\n".formatted(cell, before, cell));
            before = "c" + cell + ".o";
        }
        return text + "connect " + before + " -> o;\n}\n";
    }

    private Promise promise(String name) {
        return Promise.of(model.component("r." + name).orElseThrow(), List.of());
    }

    private Verdict ask(ExploredSearches searches, Budget budget) {
        return searches.told(
                Refinement.check(
                        row, any, budget, one -> Optional.of(searches.stores(one, budget))));
    }

    @Test
    void goOnInTurns() throws IOException {
        Verdict inMemory = Refinement.check(row, any, ALL);
        assertThat(inMemory.answer()).isEqualTo(Answer.HOLDS);
        try (ExploredSearches searches = new ExploredSearches("kept", folder, HEAP)) {
            for (int most = 100; most <= 400; most *= 2) {
                Verdict verdict = ask(searches, ALL.atMost(most));
                assertThat(verdict.answer()).isEqualTo(Answer.UNKNOWN);
                assertThat(verdict.notes()).anyMatch(note -> note.contains("kept in 'kept'"));
            }
        }
        try (ExploredSearches searches = new ExploredSearches("kept", folder, HEAP)) {
            assertThat(ask(searches, ALL)).isEqualTo(inMemory);
            assertThat(ask(searches, ALL)).isEqualTo(inMemory);
        }
    }
}
