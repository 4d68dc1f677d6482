package arcomat.analysis.search.encoding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.model.Component;
import arcomat.models.ReadModels;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Invariants that look at many parts, more than can be told apart all together: the second engine
 * is asked about what is said of few. A row of cells has too many configurations for a search.
 */
class WideInvariantTest {
    private static final int CELLS = 40;
    private static final int MOST_PAIRS = 250_000;

    private static final String CELL =
            """
            component Cell {
                port <<total>> in Integer[0..2] i, <<total>> out Integer[0..2] o;
                <<completion = "ignore">> automaton {
                    state s;
                    initial s / {o = 0};
                    s {i == 0} / {o = 0};
                    s {i == 1} / {o = 1};
                    s {i == 2} / {o = 2};
                }
            }
            """;

    /** What is read outside is 0 or 1. */
    private static String row(String invariant) {
        List<String> lines = new ArrayList<>();
        lines.add("port <<total>> in Integer[0..1] e;");
        for (int k = 0; k < CELLS; k++) {
            lines.add("component Cell c%d;".formatted(k));
            lines.add("connect %s -> c%d.i;".formatted(k == 0 ? "e" : "c" + (k - 1) + ".o", k));
        }
        lines.add("inv safe: " + invariant + ";");
        return "component Row {\n    " + String.join("\n    ", lines) + "\n}\n";
    }

    private static String all(String each) {
        return IntStream.range(0, CELLS)
                .mapToObj(k -> each.formatted(k))
                .collect(Collectors.joining(" && "));
    }

    private static Answer verdict(String invariant, boolean symbolic) {
        Component row =
                ReadModels.model(
                                new SourceFile("Cell.arc", CELL),
                                new SourceFile("Row.arc", row(invariant)))
                        .component("Row")
                        .orElseThrow();
        Budget budget =
                new Budget(() -> false, MOST_PAIRS)
                        .with(each -> each != Shortcut.SYMBOLIC || symbolic);
        return InvariantProof.check(row, List.of(), row.invariants().get(0), budget).answer();
    }

    @Test
    void whatHoldsOfEachIsProved() {
        assertThat(verdict(all("c%d.o != 2"), true)).isEqualTo(Answer.HOLDS);
        assertThat(verdict(all("c%d.o != 2"), false)).isEqualTo(Answer.UNKNOWN);
    }

    @Test
    void notOneOfThemIsProvedAsWell() {
        String some = all("c%d.o != 2").replace("!=", "==").replace("&&", "||");
        assertThat(verdict("!(" + some + ")", true)).isEqualTo(Answer.HOLDS);
    }

    /** The last one is 1 after forty slices: too far for the search. */
    @Test
    void whatFailsOfOneIsNotProved() {
        String last = " && c%d.o != 1".formatted(CELLS - 1);
        assertThat(verdict(all("c%d.o != 2") + last, true)).isEqualTo(Answer.UNKNOWN);
        assertThat(verdict("c39.o != 1 && " + all("c%d.o != 2"), true)).isEqualTo(Answer.UNKNOWN);
    }
}
