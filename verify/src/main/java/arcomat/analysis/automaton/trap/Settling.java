package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.induction.CandidateConditions;
import arcomat.analysis.automaton.induction.InductiveConditions;
import arcomat.analysis.automaton.induction.Move;
import arcomat.analysis.automaton.induction.Region;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Expression;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;

/**
 * Finds out from which states something can be sent, wherever a run is there. A state is settled
 * once there is no configuration of it, of those that may be reached, in which none of the plans is
 * possible. Such a configuration is an example: either there is a plan from there, which is made a
 * plan for many, or it belongs to a trap; else the state stays open.
 *
 * @param <T> formulas of the solver that is asked
 */
final class Settling<T> {
    /** Examples for one question. */
    private static final int MOST_EXAMPLES = 40;

    /** Attempts to enlarge a trap. */
    private static final int MOST_ENLARGED = 200;

    private final Subject subject;
    private final List<Move> moves;
    private final Insight insight;
    private final CandidateConditions candidates;
    private final PlanConditions conditions;
    private final Generalization generalization;
    private final StateQuestion<T> question;
    private final EscapeSearch<T> escapes;
    private final InductiveConditions<T> induction;
    private boolean doubtful;

    Settling(
            Subject subject,
            List<Move> moves,
            Insight insight,
            Logic.Kind<T> kind,
            BooleanSupplier stop) {
        this.subject = subject;
        this.moves = moves;
        this.insight = insight;
        this.candidates = new CandidateConditions(subject, moves);
        this.conditions = PlanConditions.of(subject);
        this.generalization =
                new Generalization(subject.component().inputs(), subject.automaton().variables());
        this.question = new StateQuestion<>(subject, kind.about(subject, stop));
        this.escapes = new EscapeSearch<>(subject, moves, kind, stop);
        this.induction = new InductiveConditions<>(subject, moves, kind.about(subject, stop));
    }

    /** Whether another solver would not find out more. */
    boolean isConclusive() {
        boolean isExact = question.isExact() && escapes.isExact() && induction.isExact();
        return insight.open().isEmpty() || isExact && !doubtful;
    }

    void run() {
        insight.stuck.clear();
        insight.learn(induction.ofRuns(candidates.all()));
        induction.know(insight.facts());
        boolean goesOn = true;
        while (goesOn && !insight.open().isEmpty()) {
            goesOn = settleOne() || settleByMeasure();
        }
    }

    private boolean settleOne() {
        boolean any = false;
        for (int state : insight.open()) {
            if (isSettled(state, Optional.empty(), Set.of())) {
                insight.settled.add(state);
                any = true;
            }
        }
        return any;
    }

    /** Some states together: each leads out of them, or closer to that. */
    private boolean settleByMeasure() {
        for (RankingFunction measure : new RankingFunctions(subject, moves).of(insight.open())) {
            Set<Integer> states = settledBy(measure);
            if (!states.isEmpty()) {
                insight.settled.addAll(states);
                return true;
            }
        }
        return false;
    }

    private Set<Integer> settledBy(RankingFunction measure) {
        Set<Integer> states = new TreeSet<>(insight.open());
        boolean changed = true;
        while (changed && !states.isEmpty()) {
            int traps = insight.traps.size();
            Set<Integer> before = Set.copyOf(states);
            states.removeIf(state -> !isSettled(state, Optional.of(measure), before));
            changed = states.size() < before.size() || insight.traps.size() > traps;
        }
        return states;
    }

    /** Whether there is a plan wherever a run is in a state, but for the traps. */
    private boolean isSettled(int state, Optional<RankingFunction> measure, Set<Integer> closer) {
        Set<Spot> seen = new LinkedHashSet<>();
        while (seen.size() < MOST_EXAMPLES) {
            Goals goals = new Goals(insight.settled, measure, closer, insight.traps);
            List<Spot> example = new ArrayList<>();
            Logic.Answer answer =
                    question.hasOther(
                            state,
                            insight.facts().in(state),
                            insight.traps,
                            possibilities(state, goals),
                            example::add);
            if (answer == Logic.Answer.NO) {
                insight.stuck.remove(state);
                return true;
            }
            if (answer == Logic.Answer.UNKNOWN) {
                doubtful = true;
                return false;
            }
            Spot spot = example.get(0);
            if (!seen.add(spot) || !learns(spot, goals)) {
                insight.stuck.put(state, spot);
                return false;
            }
        }
        return false;
    }

    private List<StateQuestion.Possibility> possibilities(int state, Goals goals) {
        List<StateQuestion.Possibility> all = new ArrayList<>();
        for (EscapePlan plan : insight.plans(state)) {
            goals.condition(plan, conditions)
                    .map(each -> new StateQuestion.Possibility(each, insight.silent(plan)))
                    .ifPresent(all::add);
        }
        return all;
    }

    /** A plan from there, or that it is in a trap; short plans are found sooner than traps. */
    private boolean learns(Spot spot, Goals goals) {
        return learns(escapes.near(spot, goals), spot, goals)
                || isTrapped(spot)
                || learns(escapes.far(spot, goals), spot, goals);
    }

    private boolean learns(Optional<EscapePlan> plan, Spot spot, Goals goals) {
        for (EscapePlan each : plan.map(generalization::of).orElse(List.of())) {
            goals.condition(each, conditions)
                    .filter(condition -> spot.satisfies(condition, subject))
                    .ifPresent(condition -> insight.plan(each, condition));
        }
        return plan.isPresent();
    }

    private boolean isTrapped(Spot spot) {
        Optional<Region> trap = trap(spot);
        trap.ifPresent(insight.traps::add);
        return trap.isPresent();
    }

    /** A trap that a configuration is in: first a large one. */
    private Optional<Region> trap(Spot spot) {
        List<Expression> near = new ArrayList<>(candidates.all());
        near.addAll(candidates.near(spot.configuration().variables()));
        List<List<Expression>> stages = List.of(List.of(), candidates.asked(), near);
        for (Set<Port> latched : new LinkedHashSet<>(List.of(Set.<Port>of(), spot.latched()))) {
            for (List<Expression> stage : stages) {
                Region region =
                        new Region(
                                induction.from(List.of(spot.configuration()), latched, stage),
                                latched);
                if (induction.isTrap(region)) {
                    return Optional.of(enlarged(region));
                }
            }
        }
        return Optional.empty();
    }

    /** What is not needed for it is left out, the last first. */
    private Region enlarged(Region trap) {
        Region region = trap;
        int attempts = 0;
        for (Map.Entry<Integer, List<Expression>> each : trap.conditions().entrySet()) {
            int state = each.getKey();
            List<Expression> all = each.getValue();
            for (int i = all.size() - 1; i >= 0 && attempts++ < MOST_ENLARGED; i--) {
                Region larger = region.without(Objects.requireNonNull(all.get(i)), state);
                region = induction.isTrapAlso(state, larger) ? larger : region;
            }
        }
        return region;
    }
}
