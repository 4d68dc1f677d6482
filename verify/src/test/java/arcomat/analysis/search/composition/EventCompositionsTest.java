package arcomat.analysis.search.composition;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Replay;
import arcomat.analysis.SimulatedRuns;
import arcomat.analysis.SimulatedRuns.Run;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Sent;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;

/** The steps of an event-driven composition are the runs of the simulator, no more and no less. */
class EventCompositionsTest {
    private static final int WORDS = 12;

    private int runs;
    private int errors;
    private int choices;
    private int sending;
    private int leftOut;

    @Tag("slow")
    @Test
    void stepsAreTheRunsOfTheSimulator() {
        for (int seed = 0; seed < 120; seed++) {
            compare(seed, false, WORDS);
        }
        assertThat(runs).isGreaterThan(1_500);
        assertThat(errors).isBetween(runs / 20, runs / 2);
        assertThat(choices).isGreaterThan(150);
        assertThat(sending).isGreaterThan(runs / 2);
        assertThat(leftOut).isZero();
    }

    @Test
    void alsoWhereMessagesCircle() {
        for (int seed = 0; seed < 25; seed++) {
            compare(seed, true, 3);
        }
        assertThat(errors).isGreaterThan(10);
        assertThat(runs - errors).isGreaterThan(30);
        assertThat(leftOut).isLessThan(20);
    }

    /** Against an edited version of itself: failures are replayed, what holds is tried. */
    @Tag("slow")
    @Test
    void verdictsAreThoseOfTheSimulator() {
        int holds = 0;
        int fails = 0;
        for (int seed = 0; seed < 60; seed++) {
            Promise whole = Promise.of(RandomCompositions.of(seed, false), List.of());
            Promise edited = Promise.of(RandomCompositions.edited(seed), List.of());
            for (boolean swapped : List.of(false, true)) {
                Promise left = swapped ? edited : whole;
                Promise right = swapped ? whole : edited;
                Verdict verdict = Refinement.check(left, right, new Budget(() -> false, 100_000));
                if (verdict.answer() == Answer.FAILS) {
                    Replay.check(left, right, verdict);
                    fails++;
                } else {
                    assertThat(verdict.answer()).isEqualTo(Answer.HOLDS);
                    tryWords(left.component(), right.component(), seed);
                    holds++;
                }
            }
        }
        assertThat(holds).isGreaterThan(30);
        assertThat(fails).isGreaterThan(20);
    }

    private static void tryWords(Component left, Component right, long seed) {
        Random random = new Random(seed);
        for (int word = 0; word < WORDS; word++) {
            List<Letter> letters =
                    word(left, random).stream().map(letter -> letter(left, letter)).toList();
            assertThat(SimulatedRuns.of(right, List.of(), letters))
                    .as(() -> RandomCompositions.text(seed, false))
                    .containsAll(SimulatedRuns.of(left, List.of(), letters));
        }
    }

    private void compare(long seed, boolean circles, int words) {
        Component whole = RandomCompositions.of(seed, circles);
        List<String> outputs = whole.outputs().stream().map(Port::name).toList();
        TransitionSystem side =
                NetworkSystem.of(whole, List.of(), outputs, new OutputCubes(), Budget.ofMemory());
        Random random = new Random(seed);
        for (int word = 0; word < words; word++) {
            List<Value[]> letters = word(whole, random);
            Set<Run> expected =
                    SimulatedRuns.of(
                            whole,
                            List.of(),
                            letters.stream().map(letter -> letter(whole, letter)).toList());
            Set<Run> found = new LinkedHashSet<>();
            Steps openings = side.openings();
            for (int step = 0; step < openings.size(); step++) {
                follow(side, openings, step, letters, List.of(), found);
            }
            if (side.leftOut().isPresent()) {
                leftOut++;
                assertThat(side.leftOut().get()).startsWith("messages circle");
                assertThat(expected).containsAll(found);
                continue;
            }
            assertThat(found)
                    .as(() -> RandomCompositions.text(seed, circles))
                    .containsExactlyInAnyOrderElementsOf(expected);
            count(expected);
        }
    }

    private void count(Set<Run> expected) {
        runs += expected.size();
        errors += (int) expected.stream().filter(Run::error).count();
        choices += expected.size() > 1 ? 1 : 0;
        sending +=
                (int)
                        expected.stream()
                                .filter(r -> r.outputs().stream().anyMatch(o -> !o.isEmpty()))
                                .count();
    }

    /** Three events; the latched port holds what it has got. */
    private static List<Value[]> word(Component whole, Random random) {
        List<Value[]> letters = new ArrayList<>();
        Value held = null;
        for (int i = 0; i < 3; i++) {
            Value[] letter = new Value[3];
            letter[random.nextInt(2)] = new Value.IntegerValue(random.nextInt(3));
            held = random.nextBoolean() ? held : new Value.IntegerValue(random.nextInt(3));
            letter[2] = held;
            letters.add(letter);
        }
        assertThat(whole.inputs().get(2).latched()).isTrue();
        return letters;
    }

    private static Letter letter(Component whole, Value[] values) {
        return Letter.of(whole.inputs(), values);
    }

    private static void follow(
            TransitionSystem side,
            Steps steps,
            int step,
            List<Value[]> letters,
            List<Map<String, List<Value>>> before,
            Set<Run> found) {
        if (steps.outputs()[step] == OutputCubes.ERROR) {
            found.add(new Run(before, true));
            return;
        }
        List<Map<String, List<Value>>> outputs = new ArrayList<>(before);
        outputs.add(outputs(side, steps, step));
        if (outputs.size() > letters.size()) {
            found.add(new Run(outputs, false));
            return;
        }
        Value[] letter = letters.get(outputs.size() - 1);
        int configuration = steps.next()[step];
        int[] positions = IntStream.range(0, letter.length).toArray();
        long kind = side.letterClasses(configuration).kind(letter, positions);
        Steps next = side.steps(configuration, kind, letter);
        for (int i = 0; i < next.size(); i++) {
            follow(side, next, i, letters, outputs, found);
        }
    }

    private static Map<String, List<Value>> outputs(TransitionSystem side, Steps steps, int step) {
        Map<String, List<Value>> outputs = new LinkedHashMap<>();
        List<Sent> sent = steps.whole().get(step).ports();
        for (int i = 0; i < sent.size(); i++) {
            List<Value> values = ((Sent.Messages) sent.get(i)).values();
            if (!values.isEmpty()) {
                outputs.put(side.outputs().get(i).name(), values);
            }
        }
        return outputs;
    }
}
