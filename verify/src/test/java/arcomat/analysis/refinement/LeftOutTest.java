package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.Replay;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.packed.PackedComparison;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What packed searches leave out changes no answer, and no counterexample's length and number of
 * messages; one that is told has been followed through the whole system.
 */
class LeftOutTest {
    private static final int QUESTIONS = Integer.getInteger("leftOut.questions", 80);
    private static final int SEED = Integer.getInteger("leftOut.seed", 23);
    private static final Budget BUDGET = new Budget(() -> false, 20_000);

    private final Map<Shortcut, Map<Answer, Integer>> taken = new EnumMap<>(Shortcut.class);

    /** An answer, and of a counterexample how long and how loud it is. */
    private record Told(Answer answer, Optional<Boolean> simulation, int moments, int messages) {
        static Told of(Verdict verdict) {
            int messages = 0;
            for (var moment : verdict.trace()) {
                messages += moment.input().messages().size();
            }
            return new Told(
                    verdict.answer(), verdict.simulation(), verdict.trace().size(), messages);
        }
    }

    @Tag("slow")
    @Test
    void changesNothingInNetworks() {
        RandomNetworks networks = new RandomNetworks(SEED);
        for (int i = 0; i < QUESTIONS; i++) {
            RandomNetworks.Question question = networks.question();
            compare(question.left(), question.right(), question.text());
        }
        assertTaken(Shortcut.CONE);
    }

    @Tag("slow")
    @Test
    void changesNothingInRows() {
        for (int i = 0; i < QUESTIONS / 2; i++) {
            RandomRows rows = RandomRows.withSides(SEED + i);
            compare(rows.whole("Whole"), rows.whole("Any"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Several"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Some"), rows.toString());
        }
        assertTaken(Shortcut.CONE);
        assertTaken(Shortcut.UNREAD_VARIABLES);
    }

    @Tag("slow")
    @Test
    void changesNothingAmongEqualParts() {
        for (int i = 0; i < QUESTIONS; i++) {
            RandomRows rows = RandomRows.equal(SEED + i);
            compare(rows.whole("Whole"), rows.whole("Any"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Several"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Some"), rows.toString());
        }
        assertTaken(Shortcut.EQUAL_PARTS);
    }

    /** A counter that counts for ever would be in more configurations than anybody can meet. */
    @Test
    void decidesBesideAnEndlessCounter() {
        Model model =
                ReadModels.model(
                        List.of(
                                file("Pass", "Integer n = 0;", ", n = n + 1"),
                                file("Plain", "", ""),
                                new SourceFile(
                                        "e/Whole.arc",
                                        """
                                        package e;
                                        component Whole {
                                          port in Boolean i, out Boolean o;
                                          component Pass p;
                                          connect i -> p.i;
                                          connect p.o -> o;
                                        }
                                        """)));
        Promise whole = Promise.of(model.component("e.Whole").orElseThrow(), List.of());
        Promise plain = Promise.of(model.component("e.Plain").orElseThrow(), List.of());
        Budget few = new Budget(() -> false, 1_000);
        assertThat(Refinement.compare(whole, plain, few).answer()).isEqualTo(Answer.HOLDS);
        Budget all = few.with(rule -> !PackedComparison.LEFT_OUT.contains(rule));
        assertThat(Refinement.compare(whole, plain, all).answer()).isEqualTo(Answer.UNKNOWN);
    }

    private static SourceFile file(String name, String variable, String assignment) {
        return new SourceFile(
                "e/" + name + ".arc",
                """
                package e;
                component %s {
                  port in Boolean i, out Boolean o;
                  <<completion = "ignore">> automaton {
                    state s;
                    %s
                    initial s;
                    s {i == true} / {o = true%s};
                  }
                }
                """
                        .formatted(
                                name,
                                variable.isEmpty() ? "" : "variable " + variable,
                                assignment));
    }

    private void assertTaken(Shortcut rule) {
        assertThat(taken.get(rule).get(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(taken.get(rule).get(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
    }

    private void compare(Promise left, Promise right, String text) {
        Set<Shortcut> rules = EnumSet.noneOf(Shortcut.class);
        Verdict quick =
                Refinement.compare(left, right, BUDGET.with(rule -> rules.add(rule) || true));
        Verdict thorough =
                Refinement.compare(
                        left,
                        right,
                        BUDGET.with(rule -> !PackedComparison.LEFT_OUT.contains(rule)));
        if (thorough.answer() != Answer.UNKNOWN) {
            assertThat(Told.of(quick)).as(text).isEqualTo(Told.of(thorough));
        }
        if (!quick.trace().isEmpty()) {
            Replay.check(left, right, quick);
        }
        for (Shortcut rule : rules) {
            taken.computeIfAbsent(rule, each -> new EnumMap<>(Answer.class))
                    .merge(quick.answer(), 1, Integer::sum);
        }
    }
}
