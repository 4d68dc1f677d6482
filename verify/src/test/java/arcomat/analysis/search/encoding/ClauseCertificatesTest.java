package arcomat.analysis.search.encoding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.Sections;
import arcomat.analysis.Sections.Section;
import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.ComparedSystems;
import arcomat.analysis.refinement.InvariantCertification;
import arcomat.analysis.refinement.RandomRows;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.VerdictsTest;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.model.Model;
import arcomat.report.verdict.CertificateText;
import arcomat.report.verdict.CertificateText.Proof;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Clauses as certificates: what is a proof is accepted, what is none is refused, and it is said
 * why. In {@code clauses/checks.txt}, below {@code == inv COMPONENT INVARIANT} or {@code == refines
 * A B} a line says {@code proof} or a part of what is wrong, and the lines below it are those of
 * certificates.
 */
class ClauseCertificatesTest {
    private static final Path CHECKS =
            Path.of("verify/src/test/resources/analysis/clauses/checks.txt");
    private static final int QUESTIONS = Integer.getInteger("clauses.questions", 30);
    private static final int SEED = Integer.getInteger("clauses.seed", 41);
    private static final long WORK = 20_000_000;
    private static final Budget BUDGET = new Budget(() -> false, 20_000);

    private int proofs;
    private int failed;
    private int excluded;
    private int changed;
    private int refused;

    @TestFactory
    Stream<DynamicTest> checks() {
        Sections sections = Sections.read(CHECKS);
        Model model = sections.model();
        return sections.tests(Set.of("inv", "refines"), each -> check(model, each));
    }

    private static void check(Model model, Section section) {
        List<String> proof = section.lines().subList(1, section.lines().size());
        String text = "arcomat certificates 1\n" + String.join("\n", proof);
        List<Certificate> certificates =
                CertificateText.parse(text).orElseThrow().stream()
                        .map(Proof::certificates)
                        .findFirst()
                        .orElse(List.of());
        assertThat(problem(model, section, certificates).orElse("proof"))
                .contains(section.lines().get(0));
    }

    private static Optional<String> problem(
            Model model, Section section, List<Certificate> certificates) {
        String[] names = section.rest().split(" ");
        Promise left = VerdictsTest.promise(model, names[0], '-');
        return section.kind().equals("inv")
                ? InvariantCertification.problem(
                        left, invariant(left.component(), names[1]), certificates, BUDGET)
                : Certification.problem(
                        left, VerdictsTest.promise(model, names[1], '-'), certificates, BUDGET);
    }

    private static Invariant invariant(Component component, String name) {
        return component.invariants().stream()
                .filter(each -> each.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** Of rows and rings, and of networks at random. */
    @Tag("slow")
    @Test
    void whatIsFoundIsAProofAndWhatIsWrongIsNone() {
        for (int i = 0; i < QUESTIONS; i++) {
            RandomRows rows = new RandomRows(SEED + i);
            compare(rows.whole("Whole"), rows.whole("Any"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Some"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Several"), rows.toString());
            RandomRows equal = RandomRows.equal(SEED + i);
            compare(equal.whole("Whole"), equal.whole("Some"), equal.toString());
        }
        RandomNetworks networks = new RandomNetworks(SEED);
        for (int i = 0; i < QUESTIONS; i++) {
            RandomNetworks.Question question = networks.question();
            compare(question.left(), question.right(), question.text());
        }
        String counts =
                "%d proofs, %d failed, %d changed, %d refused, %d of these exclude what is met"
                        .formatted(proofs, failed, changed, refused, excluded);
        assertThat(proofs).as(counts).isGreaterThan(QUESTIONS / 3);
        assertThat(failed).as(counts).isGreaterThan(QUESTIONS / 3);
        assertThat(excluded).as(counts).isGreaterThan(QUESTIONS);
        assertThat(refused).as(counts).isGreaterThan(changed / 2);
    }

    private void compare(Promise left, Promise right, String text) {
        if (Refinement.comparable(left, right).isPresent() || !left.isComposition()) {
            return;
        }
        Budget explicit = BUDGET.with(rule -> rule != Shortcut.SYMBOLIC);
        Answer answer = Refinement.compare(left, right, explicit).answer();
        Optional<Certificate> found = ComparedSystems.of(left, right, BUDGET).clauses(WORK, BUDGET);
        if (answer == Answer.FAILS) {
            assertThat(found).as(text).isEmpty();
            failed++;
            List<Certificate> wrong = ClauseChanges.guesses(left, right, BUDGET);
            wrong.forEach(each -> assertThat(accepts(left, right, each)).as(text).isFalse());
        } else if (found.isPresent()) {
            assertThat(accepts(left, right, found.get())).as(text).isTrue();
            proofs++;
            change(left, right, found.get(), text);
        }
    }

    /** What excludes a configuration that is met is no proof, and is refused. */
    private void change(Promise left, Promise right, Certificate proof, String text) {
        List<Set<String>> met = ClauseChanges.met(left, right, BUDGET);
        for (Certificate other : ClauseChanges.of(proof, met)) {
            boolean accepted = accepts(left, right, other);
            boolean wrong = excludes(other, met);
            assertThat(accepted && wrong).as("%s%n%s", text, other).isFalse();
            changed++;
            refused += accepted ? 0 : 1;
            excluded += wrong ? 1 : 0;
        }
    }

    private static boolean excludes(Certificate certificate, List<Set<String>> met) {
        return certificate.entries().stream()
                .map(Entry::right)
                .anyMatch(cube -> met.stream().anyMatch(each -> ClauseChanges.isIn(each, cube)));
    }

    private static boolean accepts(Promise left, Promise right, Certificate certificate) {
        return Certification.problem(left, right, List.of(certificate), BUDGET).isEmpty();
    }

    /** Each clause of a ring is needed. */
    @Test
    void noClauseIsLeftOut() {
        Model model = Sections.read(CHECKS).model();
        Promise ring = VerdictsTest.promise(model, "c.Ring", '-');
        Invariant one = invariant(ring.component(), "one");
        Certification proof = InvariantCertification.of(ring, one, BUDGET);
        assertThat(proof.verdict().answer()).isEqualTo(Answer.HOLDS);
        Certificate certificate = proof.certificates().get(0);
        assertThat(certificate.form()).isEqualTo(Certificate.Form.CLAUSES);
        assertThat(InvariantCertification.problem(ring, one, proof.certificates(), BUDGET))
                .isEmpty();
        for (int i = 0; i < certificate.entries().size(); i++) {
            List<Entry> rest = new ArrayList<>(certificate.entries());
            rest.remove(i);
            List<Certificate> weaker = List.of(new Certificate(certificate.form(), rest));
            assertThat(InvariantCertification.problem(ring, one, weaker, BUDGET)).isPresent();
        }
    }
}
