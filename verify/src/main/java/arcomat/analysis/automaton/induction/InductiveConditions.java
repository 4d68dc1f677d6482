package arcomat.analysis.automaton.induction;

import arcomat.analysis.reachability.Instant;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.StateFacts;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.reachability.SymbolicTransitions;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation.Start;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.BiPredicate;
import java.util.stream.Stream;

/**
 * Which of some conditions always hold in each state, whatever is read: the strongest conjunction
 * of them that transitions keep, found by leaving out what some transition breaks (Houdini:
 * Flanagan, Leino, FME 2001). A state that no transition leads to has none.
 *
 * @param <T> formulas of the solver
 */
public final class InductiveConditions<T> {
    private final Subject subject;
    private final Logic<T> logic;
    private final List<Move> moves;
    private final SymbolicTransitions<T> before;
    private final SymbolicTransitions<T> after;
    private final Map<Move, T> steps = new HashMap<>();
    private final Map<Move, T> escapes = new HashMap<>();
    private final Map<Expression, BiPredicate<Configuration, Input>> tests = new HashMap<>();
    private StateFacts known = StateFacts.NONE;

    public InductiveConditions(Subject subject, List<Move> moves, Logic<T> logic) {
        this.subject = subject;
        this.logic = logic;
        this.moves = moves;
        this.before = new SymbolicTransitions<>(subject, logic, logic.instant());
        Instant<T> next = logic.instant();
        this.after = new SymbolicTransitions<>(subject, logic, next);
        logic.claim(before.wellFormed());
        logic.claim(next.isWellTyped());
    }

    /** Whether nothing so far had to be replaced by something that may be anything. */
    public boolean isExact() {
        return logic.isExact();
    }

    /** These hold in each state whenever a run is there. */
    public void know(StateFacts facts) {
        known = facts;
    }

    /** What holds in each state whenever a run is there. */
    public StateFacts ofRuns(List<Expression> candidates) {
        List<Configuration> beginnings =
                subject.relation().starts().stream().map(Start::configuration).toList();
        return new StateFacts(from(beginnings, List.of(), candidates));
    }

    /**
     * What holds from some configurations on, by state.
     *
     * @param latched ports that have had a message
     */
    public Map<Integer, List<Expression>> from(
            Collection<Configuration> beginnings,
            Collection<Port> latched,
            List<Expression> candidates) {
        Map<Integer, List<Expression>> holding = new TreeMap<>();
        for (Configuration each : beginnings) {
            List<Expression> so = holding.getOrDefault(each.state(), candidates);
            holding.put(each.state(), thoseOf(so, each));
        }
        Deque<Integer> open = new ArrayDeque<>(holding.keySet());
        while (!open.isEmpty()) {
            int state = open.remove();
            for (Move move : leaving(state)) {
                while (weakens(move, latched, candidates, holding)) {
                    if (!open.contains(move.target())) {
                        open.add(move.target());
                    }
                }
            }
        }
        return holding;
    }

    private List<Move> leaving(int state) {
        return moves.stream().filter(each -> each.source() == state && !each.dead()).toList();
    }

    /** Whether a transition leads to where conditions do not hold; then these are left out. */
    private boolean weakens(
            Move move,
            Collection<Port> latched,
            List<Expression> candidates,
            Map<Integer, List<Expression>> holding) {
        List<Expression> target = holding.get(move.target());
        if (target != null && target.isEmpty()) {
            return false;
        }
        List<T> assumed = assumed(move.source(), latched, holding);
        assumed.add(step(move));
        if (target != null) {
            assumed.add(logic.not(logic.and(target.stream().map(after::holds).toList())));
        }
        List<Configuration> example = new ArrayList<>();
        Logic.Answer answer = logic.assuming(assumed, () -> example.add(exampleAfter()));
        if (answer == Logic.Answer.NO) {
            return false;
        }
        List<Expression> left =
                answer == Logic.Answer.YES
                        ? thoseOf(target == null ? candidates : target, example.get(0))
                        : List.of();
        boolean stays = target != null && left.size() == target.size();
        holding.put(move.target(), stays ? List.of() : left);
        return true;
    }

    private Configuration exampleAfter() {
        var place = after.instant().place();
        return new Configuration(place.state(), place.variables().toArray(Value[]::new));
    }

    private List<T> assumed(
            int state, Collection<Port> latched, Map<Integer, List<Expression>> holding) {
        List<T> assumed = new ArrayList<>();
        assumed.add(before.instant().isIn(state));
        latched.forEach(port -> assumed.add(before.isLatched(port)));
        Stream.concat(Objects.requireNonNull(holding.get(state)).stream(), known.in(state).stream())
                .forEach(each -> assumed.add(before.holds(each)));
        return assumed;
    }

    private T step(Move move) {
        return steps.computeIfAbsent(move, each -> before.step(each.transition(), after.instant()));
    }

    private List<Expression> thoseOf(List<Expression> conditions, Configuration configuration) {
        return conditions.stream().filter(each -> holds(each, configuration)).toList();
    }

    /** Whether a condition over the variables is true in a configuration. */
    private boolean holds(Expression condition, Configuration configuration) {
        return tests.computeIfAbsent(condition, subject.relation()::condition)
                .test(configuration, Input.of(new Value[subject.component().inputs().size()]));
    }

    /** Whether conditions that transitions keep, as those here, let nothing be sent or go wrong. */
    public boolean isTrap(Region region) {
        return region.conditions().keySet().stream().allMatch(state -> isSilent(state, region));
    }

    private boolean keeps(int state, Region region) {
        for (Move move : leaving(state)) {
            List<T> assumed = assumed(state, region.latched(), region.conditions());
            assumed.add(step(move));
            List<Expression> target = region.conditions().get(move.target());
            if (target != null) {
                assumed.add(logic.not(logic.and(target.stream().map(after::holds).toList())));
            }
            if (logic.assuming(assumed) != Logic.Answer.NO) {
                return false;
            }
        }
        return true;
    }

    /** Nothing can be sent in a state, and nothing goes wrong there. */
    private boolean isSilent(int state, Region region) {
        List<T> any = new ArrayList<>();
        for (Move move : moves) {
            if (move.source() == state) {
                any.add(escapes.computeIfAbsent(move, each -> before.holds(each.escapes())));
            }
        }
        List<T> assumed = assumed(state, region.latched(), region.conditions());
        assumed.add(logic.or(any));
        return logic.assuming(assumed) == Logic.Answer.NO;
    }

    /** Whether a region that is larger in one state only than a trap is one as well. */
    public boolean isTrapAlso(int state, Region larger) {
        return isSilent(state, larger) && keeps(state, larger);
    }
}
