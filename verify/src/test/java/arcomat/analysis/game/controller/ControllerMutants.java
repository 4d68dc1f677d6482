package arcomat.analysis.game.controller;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.game.Outcomes;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Send;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Controllers with one transition left out, led elsewhere or silenced: most of them keep the
 * requirements no more. Whether they do, {@code refines} says and a walk through both.
 */
public final class ControllerMutants {
    private static final Budget BUDGET = new Budget(() -> false, 1_000_000);

    private ControllerMutants() {}

    /** How many of some mutants break the requirements. */
    public static int agree(Promise promise, Component controller, Random random) {
        int broken = 0;
        Automaton automaton = controller.automata().get(0);
        for (int i = 0; i < automaton.transitions().size() && i < 4; i++) {
            int position = random.nextInt(automaton.transitions().size());
            Component mutant = with(mutated(automaton, position, random), controller);
            boolean keeps = Walk.broken(new Outcomes(promise.each()), mutant).isEmpty();
            assertThat(keeps(promise, mutant)).as("%s", mutant).isEqualTo(keeps);
            assertThat(promise.each().stream().allMatch(each -> keeps(each, mutant)))
                    .as("%s", mutant)
                    .isEqualTo(keeps);
            broken += keeps ? 0 : 1;
        }
        return broken;
    }

    private static boolean keeps(Promise promise, Component mutant) {
        Answer answer = Refinement.check(Promise.of(mutant, List.of()), promise, BUDGET).answer();
        assertThat(answer).isNotEqualTo(Answer.UNKNOWN);
        return answer == Answer.HOLDS;
    }

    private static List<Transition> mutated(Automaton automaton, int position, Random random) {
        List<Transition> all = new ArrayList<>(automaton.transitions());
        Transition old = all.remove(position);
        boolean total = old.sends().stream().anyMatch(send -> send.port().total());
        int kind = random.nextInt(3);
        if (kind > 0) {
            int target = kind == 1 ? random.nextInt(automaton.states().size()) : old.target();
            List<Send> sends = kind == 1 || total ? old.sends() : List.of();
            all.add(
                    position,
                    old.between(old.source(), target)
                            .with(old.guard(), old.matches(), sends, old.assignments()));
        }
        return all;
    }

    private static Component with(List<Transition> transitions, Component c) {
        Automaton a = c.automata().get(0);
        Automaton mutant =
                new Automaton(
                        a.name(),
                        a.completion(),
                        a.omitted(),
                        a.states(),
                        a.variables(),
                        a.initials(),
                        transitions,
                        a.span());
        return new Component(
                c.packageName(),
                c.name(),
                c.layer(),
                c.platform(),
                c.deploy(),
                c.profile(),
                c.queueCapacity(),
                c.cycle(),
                c.parameters(),
                c.constants(),
                c.ports(),
                new Component.Atomic(List.of(mutant)),
                c.requirements(),
                c.refines(),
                List.of(),
                c.span());
    }
}
