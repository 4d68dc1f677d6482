package arcomat.analysis.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomSketches;
import arcomat.analysis.RandomSketches.Knobs;
import arcomat.analysis.coverage.Mutants.Mutant;
import arcomat.analysis.coverage.TransitionTests.Mistake;
import arcomat.analysis.coverage.TransitionTests.Untold;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.StreamTest;
import arcomat.semantics.Promise;
import arcomat.simulate.test.StreamTestResult;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * A component with a small mistake, which then lacks something that the right one does, fails a
 * test that was made for the right one; or the suite says which mistake it does not tell.
 */
class MistakesTest {
    @Tag("slow")
    @Test
    void mistakesAreTold() {
        told(7, 15, 96);
    }

    @Tag("slow")
    @Test
    void mistakesAreToldInHundreds() {
        told(8, 7, 95);
    }

    /**
     * @param percent at least so many fail a test; the others are named
     */
    private static void told(long seed, int count, int percent) {
        int losing = 0;
        int told = 0;
        for (int i = 0; i < count; i++) {
            Random random = new Random(seed * 1000 + i);
            Knobs knobs = RandomSketches.any(random);
            Component component = RandomSketches.of(knobs, random).component("Random");
            Promise promise = Promise.of(component, List.of());
            TransitionTests.Result result = TransitionTestsTest.tests(component);
            List<StreamTest> tests = TransitionTestsTest.streams(result);
            assertThat(TransitionTestsTest.verdicts(tests, component))
                    .as("seed %d, component %d passes its own tests", seed, i)
                    .isEqualTo(result.tests().stream().map(TransitionTestsTest::passes).toList());
            Set<Mistake> untold =
                    result.untold().stream().map(Untold::mistake).collect(Collectors.toSet());
            for (Mutant mutant : new Mutants(component, component.automata().get(0)).all()) {
                Promise mistaken = promise.withAutomata(List.of(mutant.automaton()));
                Answer same = Refinement.check(promise, mistaken, Budget.ofMemory()).answer();
                if (same == Answer.HOLDS || !isMet(mutant, result)) {
                    continue;
                }
                losing++;
                boolean fails =
                        TransitionTestsTest.verdicts(
                                        tests,
                                        TransitionMutantsTest.with(component, mutant.automaton()))
                                .contains(StreamTestResult.Verdict.FAILED);
                told += fails ? 1 : 0;
                assertThat(fails || untold.contains(mutant.mistake()))
                        .as("seed %d, component %d: %s", seed, i, mutant.mistake().what())
                        .isTrue();
            }
        }
        assertThat(told).as("%d mistakes", losing).isGreaterThan(losing * percent / 100);
    }

    private static boolean isMet(Mutant mutant, TransitionTests.Result result) {
        return result.uncovered().stream()
                .noneMatch(each -> each.transition().equals(mutant.mistake().transition()));
    }
}
