package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomPairs;
import arcomat.analysis.RandomPairs.Pair;
import arcomat.analysis.Sections;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** What is proved can be verified, and what is wrong cannot be proved. */
class CertificationTest {
    private static final List<Pair> PAIRS = RandomPairs.any(21, 150);

    @Test
    void certificatesAreProofs() {
        for (Pair pair : PAIRS) {
            Certification proof = certify(pair);
            if (proof.verdict().answer() == Answer.HOLDS) {
                assertThat(
                                Certification.problem(
                                        pair.left(),
                                        pair.right(),
                                        proof.certificates(),
                                        Budget.ofMemory()))
                        .as(pair::toString)
                        .isEmpty();
            }
        }
    }

    /** Each pair of a certificate is needed, but for those that another one makes superfluous. */
    @Test
    void certificatesWithAGapAreNone() {
        int refused = 0;
        int all = 0;
        for (Pair pair : PAIRS) {
            for (Certificate certificate : certify(pair).certificates()) {
                for (int gap = 0; gap < certificate.entries().size(); gap++) {
                    List<Entry> rest = new ArrayList<>(certificate.entries());
                    rest.remove(gap);
                    List<Certificate> damaged = List.of(new Certificate(rest));
                    boolean accepted =
                            Certification.problem(
                                            pair.left(), pair.right(), damaged, Budget.ofMemory())
                                    .isEmpty();
                    refused += accepted ? 0 : 1;
                    all++;
                }
            }
        }
        assertThat(all).isGreaterThan(100);
        assertThat(refused).isGreaterThan(all / 2);
    }

    /** Not even all pairs together prove what fails. */
    @Test
    void whatFailsHasNoCertificate() {
        int failed = 0;
        for (Pair pair : PAIRS) {
            if (certify(pair).verdict().answer() == Answer.FAILS) {
                List<Certificate> everything = List.of(everything(pair));
                assertThat(
                                Certification.problem(
                                        pair.left(), pair.right(), everything, Budget.ofMemory()))
                        .as(pair::toString)
                        .isPresent();
                failed++;
            }
        }
        assertThat(failed).isGreaterThan(PAIRS.size() / 4);
    }

    /**
     * What holds between others is no proof for these, nor is the whole of it: where delays differ,
     * and where only feedback would tell the difference.
     */
    @ParameterizedTest
    @CsvSource({
        "Chain, Late, Chain, TwoLate",
        "TwoLate, TwoLate, TwoLate, Chain",
        "WL, WL, WL, Same",
        "Straight, Crossed, Crossed, Straight",
        "Crossed, Crossed, Crossed, Straight",
        "WE, WE, WE, WL"
    })
    void whatHoldsElsewhereIsNoProof(String one, String other, String left, String right)
            throws IOException {
        Model model = Sections.read(VerdictsTest.FOLDER.resolve("visible.txt")).model();
        Certification elsewhere = certify(model, one, other);
        assertThat(elsewhere.verdict().answer()).isEqualTo(Answer.HOLDS);
        assertThat(certify(model, left, right).verdict().answer()).isEqualTo(Answer.FAILS);
        assertThat(
                        Certification.problem(
                                promise(model, left),
                                promise(model, right),
                                elsewhere.certificates(),
                                Budget.ofMemory()))
                .isPresent();
    }

    private static Certification certify(Model model, String left, String right) {
        return Certification.of(promise(model, left), promise(model, right), Budget.ofMemory());
    }

    private static Promise promise(Model model, String name) {
        return VerdictsTest.promise(model, "v." + name, '-');
    }

    private static Certification certify(Pair pair) {
        return Certification.of(pair.left(), pair.right(), Budget.ofMemory());
    }

    /** Each configuration of one side with each one of the other, as far as sketches name them. */
    private static Certificate everything(Pair pair) {
        Set<Entry> entries = new LinkedHashSet<>();
        for (String left : names(pair.leftSketch().states())) {
            for (String right : names(pair.rightSketch().states())) {
                entries.add(new Entry(left, List.of(right)));
            }
        }
        return new Certificate(List.copyOf(entries));
    }

    private static List<String> names(int states) {
        List<String> names = new ArrayList<>(List.of("[chaos]", "[error]"));
        for (int state = 0; state < states; state++) {
            names.add("[%d[]]".formatted(state));
        }
        return names;
    }
}
