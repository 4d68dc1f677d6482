package arcomat.analysis.mona;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomPairs;
import arcomat.analysis.RandomPairs.Pair;
import arcomat.analysis.RandomPairs.Question;
import arcomat.analysis.RandomPairsTest;
import arcomat.analysis.Replay;
import arcomat.analysis.Sections;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.VerdictsTest;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.pipeline.analysis.InstalledMona;
import arcomat.semantics.Promise;
import arcomat.semantics.value.SmallType;

import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The engine and the program MONA give the same answers, with counterexamples of the same length.
 */
@Tag("slow")
class MonaAgreementTest {
    private static final int PAIRS = 60;
    private static final int CONJUNCTIONS = 25;

    @TestFactory
    Stream<DynamicTest> agreement() throws IOException {
        if (!InstalledMona.isThere()) {
            return Stream.of(
                    DynamicTest.dynamicTest(
                            "skipped: there is no program 'mona' on this machine",
                            () -> Assumptions.abort("no program 'mona'")));
        }
        Stream<DynamicTest> random =
                Stream.of(
                        DynamicTest.dynamicTest(PAIRS + " random pairs", this::randomPairs),
                        DynamicTest.dynamicTest("random conjunctions", this::conjunctions));
        try (Stream<Path> files = Files.list(VerdictsTest.FOLDER)) {
            return Stream.concat(
                    random, files.sorted().toList().stream().flatMap(MonaAgreementTest::ofFile));
        }
    }

    /** A third of them holds for a reason, and a third fails late. */
    private void randomPairs() {
        int kept = 0;
        int late = 0;
        for (Pair pair : RandomPairs.any(2026, PAIRS)) {
            Verdict verdict = agreed(pair.left(), pair.right());
            kept += verdict.answer() == Answer.HOLDS && !RandomPairsTest.isEmpty(verdict) ? 1 : 0;
            late += verdict.answer() == Answer.FAILS && verdict.trace().size() > 3 ? 1 : 0;
        }
        assertThat(kept).as("hold").isGreaterThanOrEqualTo(PAIRS * 3 / 10);
        assertThat(late).as("fail at length 3 or more").isGreaterThanOrEqualTo(PAIRS * 3 / 10);
    }

    /** Two automata on each side; and each side keeps its own promise. */
    private void conjunctions() {
        int kept = 0;
        int broken = 0;
        for (Question question : RandomPairs.conjunctions(2026, CONJUNCTIONS)) {
            Verdict verdict = agreed(question.left(), question.right());
            kept += verdict.answer() == Answer.HOLDS && isCalledIn(verdict) ? 1 : 0;
            broken += verdict.trace().size() > 1 ? 1 : 0;
            assertThat(agreed(question.right(), question.right()).answer()).isEqualTo(Answer.HOLDS);
        }
        assertThat(kept).as("hold").isGreaterThan(CONJUNCTIONS / 5);
        assertThat(broken).as("fail after the beginning").isGreaterThan(CONJUNCTIONS / 5);
    }

    /** Whether some automaton had a say. */
    private static boolean isCalledIn(Verdict verdict) {
        return verdict.notes().stream().anyMatch(note -> note.matches("\\d+ of .* took part"));
    }

    /** The engine's verdict, if the program has the same. */
    private static Verdict agreed(Promise left, Promise right) {
        Verdict own = Refinement.check(left, right, Budget.ofMemory());
        Verdict other = InstalledMona.verdict(left, right);
        assertThat(other.answer()).as(other.reason()).isEqualTo(own.answer());
        assertThat(other.reason()).isEqualTo(own.reason());
        assertThat(other.trace()).hasSameSizeAs(own.trace());
        if (!own.trace().isEmpty()) {
            Replay.check(left, right, own);
            Replay.check(left, right, other);
        }
        return own;
    }

    /** The questions of {@link VerdictsTest}, but for those that are not put to MONA. */
    private static Stream<DynamicTest> ofFile(Path file) {
        Sections sections = Sections.read(file);
        Model model = sections.model();
        List<DynamicTest> tests = new ArrayList<>();
        for (Sections.Section ask : sections.of("ask")) {
            String[] names = ask.rest().split(" ");
            for (String line : ask.lines()) {
                String sides = line.split(" ")[0];
                Promise left = VerdictsTest.promise(model, names[0], sides.charAt(0));
                Promise right =
                        VerdictsTest.promise(model, names[1], sides.charAt(sides.length() - 1));
                if (!isAsked(left) || !isAsked(right) || line.contains("unknown")) {
                    continue;
                }
                tests.add(
                        DynamicTest.dynamicTest(
                                file.getFileName() + " " + ask.rest() + " " + line,
                                () -> agreed(left, right)));
            }
        }
        return tests.stream();
    }

    private static boolean isAsked(Promise side) {
        return !side.isComposition()
                && side.component().profile() == Component.Profile.TIME_SYNCHRONOUS
                && side.component().ports().stream()
                        .allMatch(port -> SmallType.values(port.type()).isPresent());
    }
}
