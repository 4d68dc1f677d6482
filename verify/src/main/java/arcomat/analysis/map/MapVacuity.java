package arcomat.analysis.map;

import arcomat.analysis.map.Bridge.Sides;
import arcomat.analysis.refinement.ComparedSystems;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.semantics.Promise;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Whether a refinement through a map holds only because of the map: since no input comes through to
 * what is promised, or since what comes out is allowed whatever the concrete component does.
 */
final class MapVacuity {
    /** A remark should not take much longer than the answer that it is about. */
    private static final long MOST_PAIRS = 20_000;

    private static final long PATIENCE = 500_000;

    private final Promise concrete;
    private final Promise wanted;
    private final InterfaceMap map;
    private final Promise right;
    private final Budget budget;

    MapVacuity(Promise concrete, Promise wanted, InterfaceMap map, Promise right, Budget budget) {
        this.concrete = concrete;
        this.wanted = wanted;
        this.map = map;
        this.right = right;
        this.budget = budget.atMost(MOST_PAIRS).patient(PATIENCE);
    }

    Verdict noted(Verdict verdict) {
        Verdict told =
                Budget.within(this::reached, unknown -> Optional.<String>empty())
                        .map(verdict::with)
                        .orElse(verdict);
        return isKeptByAnything() ? told.with(kept()) : told;
    }

    /** How many transitions of what is promised any input leads to. */
    private Optional<String> reached() {
        List<Automaton> promised = wanted.automata();
        int all = promised.stream().mapToInt(each -> each.transitions().size()).sum();
        if (all == 0) {
            return Optional.empty();
        }
        ComparedSystems systems = ComparedSystems.of(right, right, budget);
        if (systems.inclusion(budget).run().stopped().isPresent()) {
            return Optional.empty();
        }
        int used = used(systems.right(), promised);
        return Optional.of(
                used == 0
                        ? "empty: through %s no input leads to any of the %d transitions of %s"
                                .formatted(map.title(), all, wanted.title())
                        : "%d of %d transitions of %s can be reached through %s"
                                .formatted(used, all, wanted.title(), map.title()));
    }

    private static int used(TransitionSystem system, List<Automaton> automata) {
        Set<Automaton.Transition> used = new HashSet<>();
        for (Trace.Cause cause : system.used()) {
            if (cause instanceof Trace.Taken taken) {
                used.add(taken.transition());
            }
        }
        return (int)
                automata.stream()
                        .flatMap(each -> each.transitions().stream())
                        .filter(used::contains)
                        .count();
    }

    /** Whether a component with the same ports that does anything keeps the promise, too. */
    private boolean isKeptByAnything() {
        Component component = concrete.component();
        Component any =
                component.like(
                        component.name(),
                        component.ports(),
                        new Component.Atomic(List.of()),
                        component.span());
        Sides sides =
                Bridge.between(new Promise(any, concrete.arguments(), List.of()), wanted, map);
        return sides.problems().isEmpty()
                && Refinement.check(sides.left(), sides.right(), budget).answer() == Answer.HOLDS;
    }

    private String kept() {
        return "empty: seen through %s, any component with the ports of %s keeps what %s promises"
                .formatted(map.title(), concrete.title(), wanted.title());
    }
}
