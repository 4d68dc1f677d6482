package arcomat.analysis.search.encoding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.InvariantCertification;
import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.product.Certificate;
import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
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

    private static final String BELOW =
            """
            component Below {
                port <<total>> in Integer[0..1] e, <<total>> out Integer[0..2] last;
                <<completion = "error">> automaton {
                    state s;
                    initial s / {last = 0};
                    s / {last = 0};
                    s / {last = 1};
                }
            }
            """;

    private static Model model(String invariant) {
        return ReadModels.model(
                new SourceFile("Cell.arc", CELL),
                new SourceFile("Below.arc", BELOW),
                new SourceFile("Row.arc", row(invariant)),
                new SourceFile("Shown.arc", shown(row(invariant))));
    }

    /** Shows what the last cell sends. */
    private static String shown(String row) {
        return row.replace("Row", "Shown")
                .replace(" e;", " e, <<total>> out Integer[0..2] last;")
                .replace("inv safe", "connect c%d.o -> last;%n    inv safe".formatted(CELLS - 1));
    }

    private static Budget budget(boolean symbolic) {
        return new Budget(() -> false, MOST_PAIRS)
                .with(each -> each != Shortcut.SYMBOLIC || symbolic);
    }

    private static Answer verdict(String invariant, boolean symbolic) {
        Component row = model(invariant).component("Row").orElseThrow();
        return InvariantProof.check(row, List.of(), row.invariants().get(0), budget(symbolic))
                .answer();
    }

    /** By clauses, which another check accepts. */
    @Test
    void whatIsProvedIsWrittenDown() {
        Promise asked = asked(all("c%d.o != 2"));
        Invariant safe = asked.component().invariants().get(0);
        Certification proof = InvariantCertification.of(asked, safe, budget(true));
        assertThat(proof.verdict().answer()).isEqualTo(Answer.HOLDS);
        assertThat(proof.certificates()).singleElement().satisfies(WideInvariantTest::isOfClauses);
        assertThat(InvariantCertification.problem(asked, safe, proof.certificates(), budget(true)))
                .isEmpty();
        Promise other = asked(all("c%d.o != 2") + " && c%d.o != 1".formatted(CELLS - 1));
        assertThat(
                        InvariantCertification.problem(
                                other,
                                other.component().invariants().get(0),
                                proof.certificates(),
                                budget(true)))
                .isPresent();
    }

    private static Promise asked(String invariant) {
        return Promise.of(model(invariant).component("Row").orElseThrow(), List.of());
    }

    @Tag("slow")
    @Test
    void whatRefinesIsWrittenDown() {
        Model model = model("c0.o != 2");
        Promise left = Promise.of(model.component("Shown").orElseThrow(), List.of());
        Promise right = Promise.of(model.component("Below").orElseThrow(), List.of());
        Certification proof = Certification.of(left, right, budget(true));
        assertThat(proof.verdict().answer()).isEqualTo(Answer.HOLDS);
        assertThat(proof.certificates()).singleElement().satisfies(WideInvariantTest::isOfClauses);
        assertThat(Certification.problem(left, right, proof.certificates(), budget(true)))
                .isEmpty();
        assertThat(Certification.of(left, right, budget(false)).verdict().answer())
                .isEqualTo(Answer.UNKNOWN);
    }

    private static void isOfClauses(Certificate certificate) {
        assertThat(certificate.form()).isEqualTo(Certificate.Form.CLAUSES);
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
