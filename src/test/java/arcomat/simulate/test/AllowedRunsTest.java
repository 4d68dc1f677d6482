package arcomat.simulate.test;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Component;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.simulate.NaiveRuns;
import arcomat.simulate.RandomSliceModels;
import arcomat.simulate.RecordedRuns;
import arcomat.simulate.run.Choice;
import arcomat.simulate.test.StreamTestResult.Verdict;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/**
 * Stream tests of random compositions: what a run shows is allowed, and everything else is judged
 * as enumeration judges it. More with {@code -Dmodels=100000}, others with {@code -Dfirst=7}.
 */
class AllowedRunsTest {
    private static final int MODELS = Integer.getInteger("models", 100);
    private static final int FIRST = Integer.getInteger("first", 0);
    private static final int SLICES = 6;

    @Test
    void whatARunShowsIsAllowed() {
        for (int seed = FIRST; seed < FIRST + MODELS; seed++) {
            int number = seed;
            boolean large = seed % 4 == 0;
            Component component = RandomSliceModels.of(seed, large);
            for (Choice choice :
                    List.of(
                            Choice.first(),
                            Choice.random(seed),
                            Choice.randomThroughout(seed),
                            Choice.randomThroughout(~seed))) {
                Trace trace = RecordedRuns.run(component, choice, seed, SLICES);
                if (trace.steps().isEmpty()) {
                    continue;
                }
                StreamTest test = RecordedRuns.test(trace, component);
                assertThat(StreamTests.run(test).verdict())
                        .as(() -> text(number, large, test))
                        .isIn(Verdict.PASSED, Verdict.VACUOUS);
            }
        }
    }

    @Test
    void enumerationJudgesAlike() {
        for (int seed = FIRST; seed < FIRST + MODELS / 2; seed++) {
            int number = seed;
            Component component = RandomSliceModels.of(seed, false);
            Random random = new Random(seed);
            Trace trace = RecordedRuns.run(component, Choice.randomThroughout(seed), seed, SLICES);
            if (trace.steps().isEmpty()) {
                continue;
            }
            for (int i = 0; i < 3; i++) {
                StreamTest test = changed(RecordedRuns.test(trace, component), random);
                Verdict verdict = StreamTests.run(test).verdict();
                assertThat(verdict)
                        .as(() -> text(number, false, test))
                        .isNotEqualTo(Verdict.UNKNOWN);
                assertThat(verdict != Verdict.FAILED)
                        .as(() -> text(number, false, test))
                        .isEqualTo(NaiveRuns.allow(test, true));
                if (verdict == Verdict.VACUOUS) {
                    assertThat(NaiveRuns.allow(test, false))
                            .as(() -> text(number, false, test))
                            .isFalse();
                }
            }
        }
    }

    /** Something else is expected, or less is looked at. */
    private static StreamTest changed(StreamTest test, Random random) {
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>(test.expected());
        for (String port : List.copyOf(expected.keySet())) {
            List<List<Value>> stream = new ArrayList<>(expected.get(port));
            if (random.nextInt(3) == 0) {
                expected.remove(port);
            } else if (!stream.isEmpty() && random.nextInt(2) == 0) {
                int value = random.nextInt(5) - 1;
                stream.set(
                        random.nextInt(stream.size()),
                        value < 0 ? List.of() : List.of(new Value.IntegerValue(value)));
                expected.put(port, stream);
            }
        }
        return RecordedRuns.test(test.component(), test.inputs(), expected);
    }

    private static String text(int seed, boolean large, StreamTest test) {
        return "seed %d\n%s\n%s\n%s"
                .formatted(
                        seed, RandomSliceModels.text(seed, large), test.inputs(), test.expected());
    }
}
