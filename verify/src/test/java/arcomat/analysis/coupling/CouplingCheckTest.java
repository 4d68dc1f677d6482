package arcomat.analysis.coupling;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomData;
import arcomat.analysis.RandomPairs;
import arcomat.analysis.RandomPairs.Pair;
import arcomat.analysis.Sections;
import arcomat.analysis.Sections.Section;
import arcomat.analysis.Verdicts;
import arcomat.analysis.bits.RandomRun;
import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.RandomQuestion;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Sides;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.VerdictsTest;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.analysis.search.product.Certificate.Form;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.report.verdict.CertificateText;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Conditions over variables as certificates: what is a proof is accepted, what is none is refused,
 * and it is said why. In the files of {@code coupling}, below {@code == check A B} a line says
 * {@code proof} or a part of what is wrong, and the lines below it are those of a certificate;
 * below {@code == ask A B} stand verdicts, as for {@link VerdictsTest}.
 */
class CouplingCheckTest {
    private static final Path CHECKS =
            Path.of("verify/src/test/resources/analysis/coupling/checks.txt");
    private static final List<Path> FILES =
            Stream.of("checks", "verdicts", "reals", "texts")
                    .map(
                            each ->
                                    Path.of(
                                            "verify/src/test/resources/analysis/coupling",
                                            each + ".txt"))
                    .toList();
    private static final String PROVED = "proved by conditions";
    private static final int RUNS = 30;

    /** Of each proof, so many changes are tried. */
    private static final int CHANGES = 2;

    /** Of so many proofs one is changed. */
    private static final int STRIDE = 3;

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> checks() {
        return FILES.stream().flatMap(CouplingCheckTest::checks);
    }

    private static Stream<DynamicTest> checks(Path file) {
        Sections sections = Sections.read(file);
        Model model = sections.model();
        return sections.tests(Set.of("check"), each -> check(model, each));
    }

    private static void check(Model model, Section section) {
        String expected = section.lines().get(0);
        List<String> proof = section.lines().subList(1, section.lines().size());
        String text = "arcomat certificates 1\ninvariant\n" + String.join("\n", proof);
        String said =
                problem(
                        model,
                        section,
                        CertificateText.parse(text).orElseThrow().get(0).certificates());
        assertThat(said).contains(expected);
    }

    private static String problem(Model model, Section section, List<Certificate> proof) {
        return problem(left(model, section), right(model, section), proof).orElse("proof");
    }

    /** Also what the check gives up with. */
    private static Optional<String> problem(Promise left, Promise right, List<Certificate> proof) {
        return Budget.within(
                () -> Certification.problem(left, right, proof, Budget.ofMemory()), Optional::of);
    }

    private static Promise left(Model model, Section section) {
        return VerdictsTest.promise(model, section.rest().split(" ")[0], '-');
    }

    private static Promise right(Model model, Section section) {
        return VerdictsTest.promise(model, section.rest().split(" ")[1], '-');
    }

    /** Such ports are there for observers only, and what they show in a completion is not told. */
    @Test
    void portsThatShowVariablesAreNotUnderstood() {
        Component says = Sections.read(CHECKS).model().component("c.Says").orElseThrow();
        Component shows =
                says.like(
                        says.name(),
                        says.ports(),
                        new Component.Atomic(
                                says.automata(), List.of(new Component.Shown("n", "y"))),
                        says.span());
        Promise promise = Promise.of(shows, List.of());
        assertThat(problem(promise, promise, List.of(everything(promise, promise))))
                .contains("a port of Says shows a variable");
    }

    /** As {@link VerdictsTest}; without conditions, these questions have no end. */
    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> verdicts() {
        return FILES.stream().flatMap(CouplingCheckTest::verdicts);
    }

    private static Stream<DynamicTest> verdicts(Path file) {
        Sections sections = Sections.read(file);
        Model model = sections.model();
        return sections.of("ask").stream()
                .flatMap(
                        ask ->
                                ask.lines().stream()
                                        .map(
                                                line ->
                                                        DynamicTest.dynamicTest(
                                                                ask.rest() + " " + line,
                                                                () -> ask(model, ask, line))));
    }

    private static void ask(Model model, Section section, String line) {
        String[] names = section.rest().split(" ");
        String expected = line.substring(line.indexOf(' ') + 1);
        Promise left = VerdictsTest.promise(model, names[0], line.charAt(0));
        Promise right = VerdictsTest.promise(model, names[1], line.charAt(2));
        Verdict verdict = Refinement.check(left, right, new Budget(() -> false, 10_000));
        assertThat(Verdicts.text(verdict, expected)).isEqualTo(expected);
    }

    /** A proof of the data is accepted, and is none where something of it is changed. */
    @Tag("slow")
    @Test
    void whatIsFoundIsAProofAndNeedsItsParts() {
        int met = 0;
        int proofs = 0;
        int refused = 0;
        int changed = 0;
        for (Path file : FILES) {
            Sections sections = Sections.read(file);
            Model model = sections.model();
            for (Section ask : sections.of("ask")) {
                if (ask.lines().get(0).contains(PROVED) && met++ % STRIDE == 0) {
                    Promise left = left(model, ask);
                    Promise right = right(model, ask);
                    Certificate proof = certificate(left, right);
                    assertThat(problem(left, right, List.of(read(proof)))).isEmpty();
                    for (Certificate other : changed(proof).stream().limit(CHANGES).toList()) {
                        changed++;
                        refused += problem(left, right, List.of(other)).isPresent() ? 1 : 0;
                    }
                    proofs++;
                }
            }
        }
        assertThat(proofs).isGreaterThan(8);
        assertThat(refused).isGreaterThan(changed * 2 / 3);
    }

    /** As it comes out of a file. */
    private static Certificate read(Certificate proof) {
        byte[] file =
                CertificateText.render("A", "B", List.of(), List.of(proof))
                        .getBytes(StandardCharsets.UTF_8);
        return CertificateText.parse(new String(file, StandardCharsets.UTF_8))
                .orElseThrow()
                .get(0)
                .certificates()
                .get(0);
    }

    private static Certificate certificate(Promise left, Promise right) {
        Certification proof = Certification.of(left, right, Budget.ofMemory());
        assertThat(proof.verdict().answer()).isEqualTo(Answer.HOLDS);
        Certificate certificate = proof.certificates().get(0);
        assertThat(certificate.form()).isEqualTo(Form.CONDITIONS);
        return certificate;
    }

    /** Without a pair, without a condition, with another number, with another sign. */
    private static List<Certificate> changed(Certificate proof) {
        List<Certificate> all = new ArrayList<>();
        for (int i = 0; i < proof.entries().size(); i++) {
            List<Entry> rest = new ArrayList<>(proof.entries());
            Entry entry = rest.remove(i);
            all.add(new Certificate(Form.CONDITIONS, rest));
            for (int c = 0; c < entry.right().size(); c++) {
                all.add(with(proof, i, replaced(entry, c, List.of())));
                String one = entry.right().get(c);
                all.add(with(proof, i, replaced(entry, c, List.of(one.replace("==", "<=")))));
                all.add(with(proof, i, replaced(entry, c, List.of(one.replace(" is ", " == ")))));
                all.add(
                        with(
                                proof,
                                i,
                                replaced(entry, c, List.of(one.replace(" right.", " -right.")))));
            }
        }
        all.removeIf(proof::equals);
        return all;
    }

    private static Entry replaced(Entry entry, int which, List<String> other) {
        List<String> conditions = new ArrayList<>(entry.right());
        conditions.remove(which);
        conditions.addAll(which, other);
        return new Entry(entry.left(), conditions);
    }

    private static Certificate with(Certificate proof, int which, Entry other) {
        List<Entry> entries = new ArrayList<>(proof.entries());
        entries.set(which, other);
        return new Certificate(Form.CONDITIONS, entries);
    }

    /** Neither what is looked for, nor all pairs without a condition, proves what fails. */
    @Tag("slow")
    @Test
    void whatFailsIsNotProved() {
        int failed = 0;
        int proved = 0;
        for (Pair pair : RandomPairs.any(31, 300)) {
            Promise left = pair.left();
            Promise right = pair.right();
            Answer answer = Refinement.check(left, right, Budget.ofMemory()).answer();
            boolean found = Refinement.comparable(left, right).isEmpty() && isProved(left, right);
            if (answer == Answer.FAILS) {
                assertThat(found).as(pair::toString).isFalse();
                assertThat(problem(left, right, List.of(everything(left, right))))
                        .as(pair::toString)
                        .isPresent();
                failed++;
            } else {
                proved += found ? 1 : 0;
            }
        }
        assertThat(failed).isGreaterThan(60);
        assertThat(proved).isGreaterThan(30);
    }

    /** Whether what is looked for is found, and is a proof. */
    static boolean isProved(Promise left, Promise right) {
        return Budget.within(
                () -> {
                    Coupling coupling = Coupling.of(subject(left), subject(right));
                    List<Entry> entries = CouplingSearch.of(coupling, () -> false).proposal();
                    return CouplingCheck.problem(coupling, entries, () -> false).isEmpty();
                },
                reason -> false);
    }

    private static Coupling.Subject subject(Promise promise) {
        return new Coupling.Subject(
                promise.component(), promise.automata().get(0), promise.arguments());
    }

    private static Certificate everything(Promise left, Promise right) {
        List<Entry> entries = new ArrayList<>();
        for (String one : left.automata().get(0).states()) {
            for (String two : right.automata().get(0).states()) {
                entries.add(new Entry(one + " with " + two, List.of()));
            }
        }
        return new Certificate(Form.CONDITIONS, entries);
    }

    /** Of data that are only moved and compared, the search knows which fail. */
    @Tag("slow")
    @Test
    void whatFailsAboutTextsIsNotProved() {
        int failed = 0;
        int proved = 0;
        for (int seed = 0; seed < 120; seed++) {
            Sides sides = sides(new RandomData(seed).atoms(), RandomData.STRINGS);
            Answer answer = sides.check(new Budget(() -> false, 10_000)).answer();
            boolean found = isComparable(sides) && isProved(sides.left(), sides.right());
            assertThat(found && answer == Answer.FAILS).as("seed " + seed).isFalse();
            failed += answer == Answer.FAILS ? 1 : 0;
            proved += found ? 1 : 0;
        }
        assertThat(failed).isGreaterThan(20);
        assertThat(proved).isGreaterThan(20);
    }

    private static boolean isComparable(Sides sides) {
        return Refinement.comparable(sides.left(), sides.right()).isEmpty();
    }

    private static Sides sides(List<String> atoms, RandomData.Kind kind) {
        Model model = RandomData.model(atoms, kind);
        return new Sides(
                VerdictsTest.promise(model, "r.Left", '-'),
                VerdictsTest.promise(model, "r.Right", '-'));
    }

    /** Of Doubles, runs with zeros of both signs and with what is no number. */
    @Tag("slow")
    @Test
    void whatIsProvedOfRealsHoldsInRuns() {
        int proved = 0;
        for (int seed = 0; seed < 20; seed++) {
            List<String> atoms = new RandomData(seed).atoms();
            if (seed % 2 == 1) {
                atoms = atoms.stream().map(each -> each.replace(" != ", " < ")).toList();
            }
            Sides sides = sides(atoms, RandomData.REALS);
            if (isComparable(sides) && isProved(sides.left(), sides.right())) {
                proved++;
                for (int run = 0; run < RUNS; run++) {
                    RandomRun.follow(sides, new Random(run), "seed " + seed + ": " + atoms);
                }
            }
        }
        assertThat(proved).isGreaterThan(8);
    }

    /** Of random questions about Integers, the search knows which fail. */
    @Tag("slow")
    @Test
    void whatFailsAboutDataIsNotProved() {
        int failed = 0;
        int proved = 0;
        for (int seed = 0; seed < 60; seed++) {
            Sides sides = Sides.of(new RandomQuestion(seed).models());
            Answer answer = sides.check(new Budget(() -> false, 10_000)).answer();
            boolean found = isProved(sides.left(), sides.right());
            assertThat(found && answer == Answer.FAILS).as("seed " + seed).isFalse();
            failed += answer == Answer.FAILS ? 1 : 0;
            proved += found ? 1 : 0;
        }
        assertThat(failed).isGreaterThan(10);
        assertThat(proved).isGreaterThan(10);
    }
}
