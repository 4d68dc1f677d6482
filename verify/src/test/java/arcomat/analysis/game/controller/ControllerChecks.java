package arcomat.analysis.game.controller;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Verdicts;
import arcomat.analysis.game.Outcomes;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Sent;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** What is asked of every synthesised controller. */
public final class ControllerChecks {
    private static final Budget BUDGET = new Budget(() -> false, 1_000_000);

    private ControllerChecks() {}

    /** It keeps every requirement, and leaves nothing open. */
    public static void check(Promise requirements, Component controller) {
        keepsAll(requirements, controller);
        isDeterministic(controller);
    }

    public static void keepsAll(Promise requirements, Component controller) {
        requirements.each().forEach(each -> keeps(each, controller));
        keeps(requirements, controller);
        keeps(new Outcomes(requirements.each()), controller);
    }

    private static void keeps(Promise requirements, Component controller) {
        Verdict verdict = Refinement.check(Promise.of(controller, List.of()), requirements, BUDGET);
        assertThat(verdict.answer())
                .as(
                        "%s: %s %s %s",
                        requirements.title(),
                        verdict.reason(),
                        Verdicts.trace(verdict.trace()),
                        controller)
                .isEqualTo(Answer.HOLDS);
    }

    /** The same without the engine, by walking through both. */
    private static void keeps(Outcomes outcomes, Component controller) {
        assertThat(Walk.broken(outcomes, controller)).as("%s", controller).isEmpty();
    }

    /** One reaction to every input, and no transition for the completion to make up. */
    private static void isDeterministic(Component controller) {
        StepRelation relation = ComponentSemantics.of(controller, List.of()).relations().get(0);
        assertThat(relation.starts()).hasSize(1);
        Deque<Configuration> open =
                new ArrayDeque<>(List.of(relation.starts().get(0).configuration()));
        Set<Configuration> met = new HashSet<>(open);
        while (!open.isEmpty()) {
            Configuration before = open.removeFirst();
            for (var letter : Outcomes.letters(controller.inputs())) {
                StepRelation.Prospect prospect = relation.prospect(before, Input.of(letter));
                List<Reaction> reactions = prospect.reactions();
                assertThat(reactions.size() + prospect.errors().size()).isEqualTo(1);
                for (Reaction reaction : reactions) {
                    assertThat(reaction.next().isState()).isTrue();
                    assertThat(reaction.output().ports())
                            .allMatch(sent -> sent instanceof Sent.Messages);
                    if (met.add(reaction.next())) {
                        open.add(reaction.next());
                    }
                }
            }
        }
        Automaton automaton = relation.automaton();
        assertThat(met.stream().filter(Configuration::isState))
                .as("all states of %s are reached", automaton.states())
                .hasSize(automaton.states().size());
    }
}
