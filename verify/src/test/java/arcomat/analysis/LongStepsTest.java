package arcomat.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import arcomat.analysis.automaton.Analyses;
import arcomat.analysis.automaton.Examination;
import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Contradictions;
import arcomat.analysis.coverage.TransitionTests;
import arcomat.analysis.refinement.MonaRefinement;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.time.Duration;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/**
 * Models whose very first steps take longer than anybody waits: each analysis still ends when time
 * or memory is used up. Time is counted by how often it is asked for.
 */
class LongStepsTest {
    private static final long STATES = 1_000_000;

    /** Nobody gets that far: only looks in the middle of a step can end it. */
    private static final Duration HANGS = Duration.ofSeconds(60);

    private static BooleanSupplier after(int questions) {
        int[] asked = {0};
        return () -> ++asked[0] > questions;
    }

    private static Budget shortTime() {
        return new Budget(after(20_000), STATES);
    }

    private static Budget smallMemory() {
        return new Budget(() -> false, after(20_000), STATES);
    }

    private static <T> T ending(Supplier<T> analysis) {
        return assertTimeoutPreemptively(HANGS, analysis::get);
    }

    private static Promise promise(String text) {
        Model model = ReadModels.model(new SourceFile("M.arc", text));
        return Promise.of(model.component("M").orElseThrow(), List.of());
    }

    /** Tells some 100,000 inputs apart. */
    private static Promise manyLetters() {
        return manyLetters("true");
    }

    /**
     * @param reactions one automaton for each, which sends it
     */
    private static Promise manyLetters(String... reactions) {
        StringBuilder text = new StringBuilder("component M { port ");
        for (int port = 0; port < 4; port++) {
            text.append("in Integer[0..99] p").append(port).append(", ");
        }
        text.append("out Boolean o;");
        for (String reaction : reactions) {
            text.append("automaton a%s { state s; initial s / {o = true};\n".formatted(reaction));
            for (int port = 0; port < 4; port++) {
                for (int value = 0; value < 99; value += 6) {
                    text.append("s {p%d == %d} / {o = %s};\n".formatted(port, value, reaction));
                }
            }
            text.append("}");
        }
        return promise(text + "}");
    }

    /** Each of its automata has a choice of its own: 2 to the 30 steps for one input. */
    private static Promise manyChoices() {
        StringBuilder text = new StringBuilder("component M { port in Boolean a");
        for (int i = 0; i < 30; i++) {
            text.append(", out Boolean o").append(i);
        }
        text.append(";\n");
        for (int i = 0; i < 30; i++) {
            text.append(
                    "automaton r%d { state s; initial s; s {a == ?} / {%s}; s {a == ?} / {%s}; }\n"
                            .formatted(i, "o" + i + " = true", "o" + i + " = false"));
        }
        return promise(text + "}");
    }

    /** Each of its parts has a choice of its own. */
    private static Promise manyParts() {
        StringBuilder text = new StringBuilder("component M { port in Boolean a");
        for (int i = 0; i < 30; i++) {
            text.append(", out Boolean o").append(i);
        }
        text.append(
                """
                ;
                component Part {
                  port in Boolean a, out Boolean o;
                  automaton { state s; initial s; s {a == ?} / {o = true}; s {a == ?} / {o = false}; }
                }
                """);
        for (int i = 0; i < 30; i++) {
            text.append("component Part c%d; connect a -> c%d.a;".formatted(i, i));
            text.append("connect c%d.o -> o%d;\n".formatted(i, i));
        }
        return promise(text + "}");
    }

    private static void isUnknown(Verdict verdict, String reason) {
        assertThat(verdict.answer()).isEqualTo(Answer.UNKNOWN);
        assertThat(verdict.reason()).isEqualTo(reason);
        assertThat(verdict.explored().left().orElse(0)).as("configurations").isPositive();
    }

    /**
     * @param other says the same, and is not the same
     */
    private static void bothRunOut(Promise promise, Promise other) {
        isUnknown(ending(() -> Refinement.compare(promise, other, shortTime())), "the time is up");
        isUnknown(
                ending(() -> Refinement.compare(promise, other, smallMemory())), "memory is full");
        assertThat(ending(() -> Refinement.failures(promise, other, shortTime())))
                .allMatch(verdict -> verdict.answer() == Answer.UNKNOWN)
                .isNotEmpty();
    }

    @Tag("slow")
    @Test
    void refinementWithManyLetters() {
        bothRunOut(manyLetters(), manyLetters());
    }

    @Test
    void refinementWithManyParts() {
        bothRunOut(manyParts(), manyParts());
    }

    @Test
    void refinementOfManyAutomataTogether() {
        Promise all = manyChoices();
        Promise one = all.each().get(0);
        isUnknown(ending(() -> Refinement.compare(all, one, shortTime())), "the time is up");
    }

    @Test
    void aCounterexampleCountsEvenWhereTimeRunsOutBehindIt() {
        String text =
                "component M { port in Integer[0..99] i, out Boolean o; automaton { state s;"
                        + " initial s / {o = %s}; s [i == 1] {i == ?} / {o = true}; } }";
        Promise left = promise(text.formatted("true"));
        Promise right = promise(text.formatted("false"));
        Verdict verdict = Refinement.compare(left, right, new Budget(() -> false, 0));
        assertThat(verdict.answer()).isEqualTo(Answer.FAILS);
    }

    @Test
    void analyses() {
        Examination examination =
                ending(() -> Analyses.examine(manyLetters(), List.of(), few())).get(0);
        assertThat(examination.obstacle()).isEqualTo("the time is up");
        assertThat(examination.explored()).isPositive();
    }

    private static Budget few() {
        return new Budget(after(100), STATES);
    }

    @Test
    void transitionTests() {
        TransitionTests.Result result =
                ending(() -> TransitionTests.of(manyChoices(), "Suite", shortTime()));
        assertThat(result.answer()).isEqualTo(Answer.UNKNOWN);
        assertThat(result.stopped()).contains("the time is up");
        assertThat(result.configurations()).isPositive();
    }

    @Test
    void contradictions() {
        Promise promise = manyLetters("true", "false");
        Consistency found = ending(() -> Contradictions.check(promise, false, shortTime()));
        assertThat(found.answer()).isEqualTo(Answer.UNKNOWN);
        assertThat(found.reason()).isEqualTo("the time is up");
    }

    @Test
    void theQuestionForMona() {
        Component component = manyChoices().component();
        Promise promise = Promise.of(component, List.of());
        MonaRefinement refinement =
                ending(() -> MonaRefinement.of(promise, promise.each().get(0), shortTime()));
        assertThat(refinement.settled().orElseThrow().answer()).isEqualTo(Answer.UNKNOWN);
    }

    @Test
    void whatGoesWrongForLackOfMemoryIsUnknown() {
        Supplier<String> greedy =
                () -> {
                    throw new OutOfMemoryError("Java heap space");
                };
        assertThat(Budget.within(greedy, reason -> "unknown: " + reason))
                .isEqualTo("unknown: memory is full");
    }
}
