package arcomat.analysis.contradiction;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.game.CounterStrategy.Turn;
import arcomat.analysis.game.Outcomes;
import arcomat.analysis.game.controller.ControllerChecks;
import arcomat.analysis.game.controller.ControllerMutants;
import arcomat.analysis.game.controller.Walk;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * What has to hold of every answer about requirements: a controller refines them; what contradicts
 * beats every system, above all every machine of few states; minimal subsets are minimal, and none
 * is missed. By naive search and by {@code refines}, in which the game takes no part.
 */
final class RequirementLaws {
    private static final Budget BUDGET = new Budget(() -> false, 1_000_000);
    private static final int FEW_STATES = 2;
    private static final long CHOICES = 20_000;

    /** What kind of set it was, for those who count. */
    enum Kind {
        KEPT,
        KEPT_BY_ERRING,
        CONTRADICTING,
        ADAPTIVE,
        LARGE
    }

    private RequirementLaws() {}

    static Kind check(Promise promise) {
        Consistency found = Contradictions.check(promise, true, BUDGET);
        Consistency first = Contradictions.check(promise, false, BUDGET);
        assertThat(found.answer()).isEqualTo(first.answer()).isNotEqualTo(Answer.UNKNOWN);
        Outcomes outcomes = new Outcomes(promise.each());
        Optional<Boolean> lost = outcomes.isEverLost(true);
        lost.ifPresent(l -> assertThat(found.answer() == Answer.FAILS).isEqualTo(l));
        subsets(promise, found);
        if (found.answer() == Answer.HOLDS) {
            return kept(promise, outcomes, first);
        }
        List<Contradiction> all = new ArrayList<>(found.contradictions());
        all.addAll(first.contradictions());
        all.forEach(each -> contradicts(promise, each));
        boolean adaptive = all.stream().anyMatch(each -> each.word().isEmpty());
        return lost.isEmpty() ? Kind.LARGE : adaptive ? Kind.ADAPTIVE : Kind.CONTRADICTING;
    }

    private static Kind kept(Promise promise, Outcomes outcomes, Consistency found) {
        if (promise.component().profile() == Component.Profile.EVENT_DRIVEN) {
            return Kind.KEPT;
        }
        Component controller = found.controller().orElseThrow();
        ControllerChecks.check(promise, controller);
        boolean errs = mayErr(controller);
        Optional<Boolean> mustErr = new Outcomes(promise.each()).isEverLost(false);
        mustErr.ifPresent(must -> assertThat(errs).isEqualTo(must));
        assertThat(Walk.erring(new Outcomes(promise.each()), controller))
                .as("errs though it need not: %s", controller)
                .isEmpty();
        ControllerMutants.agree(promise, controller, new Random(found.explored()));
        return errs ? Kind.KEPT_BY_ERRING : Kind.KEPT;
    }

    private static boolean mayErr(Component controller) {
        StepRelation relation = ComponentSemantics.of(controller, List.of()).relations().get(0);
        List<Configuration> open =
                new ArrayList<>(List.of(relation.starts().get(0).configuration()));
        for (int i = 0; i < open.size(); i++) {
            for (Value[] letter : Outcomes.letters(controller.inputs())) {
                StepRelation.Prospect prospect = relation.prospect(open.get(i), Input.of(letter));
                if (!prospect.errors().isEmpty()) {
                    return true;
                }
                prospect.reactions().stream()
                        .map(each -> each.next())
                        .filter(next -> !open.contains(next))
                        .forEach(open::add);
            }
        }
        return false;
    }

    /** A set of requirements cannot be kept exactly if it has a minimal one within it. */
    private static void subsets(Promise promise, Consistency found) {
        List<Promise> each = promise.each();
        for (int mask = 1; mask < 1 << each.size(); mask++) {
            int chosen = mask;
            List<Automaton> some =
                    IntStream.range(0, each.size())
                            .filter(i -> (chosen >> i & 1) == 1)
                            .mapToObj(i -> promise.automata().get(i))
                            .toList();
            boolean contradicts =
                    found.contradictions().stream()
                            .anyMatch(c -> new HashSet<>(some).containsAll(c.requirements()));
            Promise part = new Promise(promise.component(), promise.arguments(), some);
            Answer expected = contradicts ? Answer.FAILS : Answer.HOLDS;
            assertThat(Contradictions.check(part, false, BUDGET).answer())
                    .as(some.stream().map(Automaton::name).toList().toString())
                    .isEqualTo(expected);
            new Outcomes(part.each())
                    .isEverLost(true)
                    .ifPresent(lost -> assertThat(lost).isEqualTo(contradicts));
        }
        for (Contradiction contradiction : found.contradictions()) {
            assertThat(contradiction.minimal()).isTrue();
            for (Contradiction other : found.contradictions()) {
                boolean within =
                        new HashSet<>(contradiction.requirements())
                                .containsAll(other.requirements());
                assertThat(within).isEqualTo(contradiction.equals(other));
            }
        }
    }

    private static void contradicts(Promise promise, Contradiction contradiction) {
        ContradictionsTest.verify(promise, contradiction);
        Promise part =
                new Promise(promise.component(), promise.arguments(), contradiction.requirements());
        Outcomes outcomes = new Outcomes(part.each());
        assertThat(beats(contradiction, outcomes)).as("beats every answer").isTrue();
        BoundedMachines.someKeeps(outcomes, FEW_STATES, CHOICES)
                .ifPresent(some -> assertThat(some).as("kept by a small machine").isFalse());
    }

    /** Whether following the steps breaks a requirement, whatever is answered. */
    static boolean beats(Contradiction contradiction, Outcomes outcomes) {
        Map<List<Integer>, Boolean> known = new HashMap<>();
        return Arrays.stream(outcomes.openings())
                .allMatch(next -> goesOn(contradiction, 0, outcomes, next, known));
    }

    /** Of the answers that are told, one leads to what beats the answer that was given. */
    private static boolean goesOn(
            Contradiction contradiction,
            int step,
            Outcomes outcomes,
            int answer,
            Map<List<Integer>, Boolean> known) {
        return answer == Outcomes.BROKEN
                || answer != Outcomes.END
                        && contradiction.steps().get(step).answers().stream()
                                .map(Turn.Answer::next)
                                .anyMatch(
                                        next ->
                                                beats(
                                                        contradiction,
                                                        next,
                                                        outcomes,
                                                        answer,
                                                        known));
    }

    private static boolean beats(
            Contradiction contradiction,
            int step,
            Outcomes outcomes,
            int position,
            Map<List<Integer>, Boolean> known) {
        List<Integer> key = List.of(step, position);
        Boolean before = known.get(key);
        if (before == null) {
            Value[] input = outcomes.letter(contradiction.steps().get(step).input());
            before =
                    outcomes.isPossible(position, input)
                            && Arrays.stream(outcomes.answers(position, input))
                                    .allMatch(
                                            answer ->
                                                    goesOn(
                                                            contradiction,
                                                            step,
                                                            outcomes,
                                                            answer,
                                                            known));
            known.put(key, before);
        }
        return before;
    }
}
